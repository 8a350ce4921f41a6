#include "polling.hpp"

#include "pmts/protocol/labels.hpp"
#include "readings.hpp"

#include <algorithm>

namespace pmts::instrument {
namespace {

using namespace std::chrono_literals;
using protocol::InfoClass;

constexpr int kRecordedBefore = 3;
constexpr int kAlikeToBelieve = 2;
constexpr int kTroubleInRow = 30;
constexpr core::Duration kLeastPause = 1ms;
/// Numbers of a block may have other decimals than the same label read alone (D-bar high resolution).
constexpr int kBlockDecimals = 1000;

PollKind kindOfStatus(const protocol::Status& status) {
    if (status.code == kRecordedBefore) {
        return PollKind::kOld;
    }
    switch (protocol::infoCode(status.code).info_class) {
        case InfoClass::kRemeasure:
            return status.code < 100 ? PollKind::kInvalid : PollKind::kRemeasure;
        case InfoClass::kComm:
        case InfoClass::kRetry:
        case InfoClass::kProtocol:
            return PollKind::kDamaged;
        default:
            return PollKind::kFailed;
    }
}

std::optional<core::Angle> angleIn(GeodimeterState& state, const CheckedBlock& block, int label) {
    const auto* text = block.find(label);
    if (text == nullptr || !isBelievableNumber(state, kBlockDecimals + label, *text)) {
        return std::nullopt;
    }
    const auto angle = circleAngle(state, *text);
    return angle ? std::optional(*angle) : std::nullopt;
}

PollOutcome damaged(PollOutcome outcome) {
    outcome.kind = PollKind::kDamaged;
    if (outcome.error.happened.isEmpty()) {
        outcome.error = {.kind = core::ErrorKind::kProtocol,
                         .happened = QObject::tr("The answer with the distance arrived damaged."),
                         .remedy = QObject::tr("Check cable and plugs, then measure again."),
                         .info_code = std::nullopt,
                         .detail = QString::fromStdString(outcome.raw)};
    }
    return outcome;
}

/// A block of data with status ok: with a distance, or still measuring.
PollOutcome fromItems(GeodimeterState& state, const CheckedBlock& block, PollOutcome outcome) {
    const auto ha = angleIn(state, block, protocol::kHa);
    const auto va = angleIn(state, block, protocol::kVa);
    notePointing(state, ha, va);
    if (ha && va) {
        outcome.pointing = geometry::Pointing{.ha = *ha, .va = *va};
    }
    const auto* distance = block.find(protocol::kSd);
    if (distance == nullptr) {
        outcome.kind = PollKind::kMeasuring;
        return outcome;
    }
    if (!isBelievableNumber(state, protocol::kSd, *distance)) {
        state.quality.trouble();
        return damaged(std::move(outcome));
    }
    outcome.kind = PollKind::kDistance;
    outcome.distance = *distance;
    return outcome;
}

}  // namespace

core::Task<PollOutcome> pollDistance(StatePtr state, std::stop_token stop) {
    Question question{.bytes = protocol::encode(protocol::ReadMeasurement{}),
                      .limit = std::max<core::Duration>(state->settings.least_read_limit, 1s),
                      .accepts = canAnswerMeasurement};
    PollOutcome outcome;
    outcome.asked_at = state->clock.now();
    auto asking = exchange(state, question, stop);
    const auto reply = co_await asking;
    if (!reply) {
        outcome.error = reply.error();
        if (reply.error().kind != core::ErrorKind::kTimeOut) {
            co_return outcome;
        }
        auto settling = settleLine(state, stop);
        const bool answers = co_await settling;
        outcome.kind = answers ? PollKind::kDamaged : PollKind::kFailed;
        co_return outcome;
    }
    const auto block = checkBlock(*reply);
    outcome.raw = reply->raw;
    if (block.kind == BlockKind::kMalformed) {
        co_return damaged(outcome);
    }
    if (const auto error = commandError(block)) {  // a warning and nothing else: no data yet
        outcome.error = *error;
        outcome.kind = kindOfStatus(*block.status);
        co_return outcome;
    }
    if (block.kind != BlockKind::kItems) {
        outcome.kind = PollKind::kMeasuring;  // "0" and nothing: no data yet
        co_return outcome;
    }
    co_return fromItems(*state, block, outcome);
}

core::Task<core::Result<void>> pauseBeforePoll(StatePtr state, core::Duration began_at,
                                               std::optional<core::Duration> soonest, int polls,
                                               std::stop_token stop) {
    constexpr double kDenseFrom = 0.9;
    if (polls == 0) {
        co_return {};
    }
    const auto dense_at = began_at + std::chrono::duration_cast<core::Duration>(
                                         kDenseFrom * soonest.value_or(core::Duration{0}));
    // On a line without pace (a test, a fast simulator) back to back would mean without end.
    const auto pause =
        std::clamp<core::Duration>(dense_at - state->clock.now(), kLeastPause, state->settings.poll_pause);
    auto pausing = core::sleepFor(state->clock, pause, stop);
    co_return co_await pausing;
}

core::Task<core::Result<void>> watchAveraging(StatePtr state, core::Duration span, std::stop_token stop) {
    const auto until = state->clock.now() + span;
    while (state->clock.now() < until) {
        auto polling = pollDistance(state, stop);
        const auto outcome = co_await polling;
        if (outcome.kind == PollKind::kFailed) {
            co_return tl::unexpected(outcome.error);
        }
        const auto left = std::max(until - state->clock.now(), core::Duration::zero());
        auto pausing = core::sleepFor(state->clock, std::min(left, state->settings.poll_pause), stop);
        PMTS_CO_TRY(co_await pausing);
    }
    co_return {};
}

PollVerdict PollJudge::judge(PollOutcome& outcome, core::Duration began_at) {
    const bool is_trouble = outcome.kind == PollKind::kDamaged;
    trouble_in_row_ = is_trouble ? trouble_in_row_ + 1 : 0;
    old_in_row_ = outcome.kind == PollKind::kOld ? old_in_row_ + 1 : 0;
    invalid_in_row_ = outcome.kind == PollKind::kInvalid ? invalid_in_row_ + 1 : 0;
    switch (outcome.kind) {
        case PollKind::kDistance:
            return outcome.asked_at - began_at < state_.settings.shortest_measurement ? PollVerdict::kGoOn
                                                                                      : PollVerdict::kFound;
        case PollKind::kMeasuring:
            was_measuring_ = true;
            return PollVerdict::kGoOn;
        case PollKind::kOld:
            return judgeOld(outcome, began_at);
        case PollKind::kInvalid:
            return judgeInvalid(began_at);
        case PollKind::kDamaged:
            answer_lost_ = true;
            return trouble_in_row_ > kTroubleInRow ? PollVerdict::kAgain : PollVerdict::kGoOn;
        case PollKind::kRemeasure:
            return PollVerdict::kAgain;
        case PollKind::kFailed:
            break;
    }
    return judgeFailure(outcome.error);
}

/// On a line that loses bytes an info code counts when it comes twice.
PollVerdict PollJudge::judgeFailure(const core::Error& error) {
    const bool doubtful = state_.quality.isNoisy() && error.info_code && error.info_code != failure_code_;
    failure_code_ = error.info_code;
    answer_lost_ = true;
    return doubtful ? PollVerdict::kGoOn : PollVerdict::kFailed;
}

/// Status 3 after "measuring" was seen: the distance is there and an answer that we lost has carried it. The
/// label still holds it; without a text of the block it must come alike as often as the line demands.
PollVerdict PollJudge::judgeOld(PollOutcome& outcome, core::Duration began_at) {
    if (was_measuring_ && answer_lost_ && old_in_row_ >= kAlikeToBelieve) {
        outcome.distance.clear();
        outcome.pointing.reset();
        return PollVerdict::kFound;
    }
    const bool over = was_measuring_
                          ? old_in_row_ >= kAlikeToBelieve
                          : state_.clock.now() - began_at >
                                state_.settings.edm.at(static_cast<std::size_t>(state_.mode)).initial_limit;
    return over ? PollVerdict::kAgain : PollVerdict::kGoOn;
}

/// 4 and 7 may say "not yet" while the instrument measures; after the usual time, or after "measuring", they
/// are final.
PollVerdict PollJudge::judgeInvalid(core::Duration began_at) {
    const auto usual = state_.settings.edm.at(static_cast<std::size_t>(state_.mode)).initial_limit;
    const bool over =
        was_measuring_ ? invalid_in_row_ >= kAlikeToBelieve : state_.clock.now() - began_at > usual;
    return over ? PollVerdict::kAgain : PollVerdict::kGoOn;
}

}  // namespace pmts::instrument
