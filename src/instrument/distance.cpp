#include "distance.hpp"

#include "pmts/core/logging.hpp"
#include "pmts/protocol/labels.hpp"
#include "distance_limit.hpp"
#include "polling.hpp"
#include "readings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::instrument {
namespace {

using core::Angle;
using protocol::InfoClass;

constexpr core::Duration kAtOnce = std::chrono::milliseconds(300);
/// On a line that loses bytes the one answer that carries the distance is lost more often than not.
constexpr int kNoisyShotAttempts = 8;

struct Attempt {
    DistanceShot shot;
    core::Error trouble;
    bool done = false;
    bool again = false;
};

Attempt failed(core::Error error) {
    return {.shot = {}, .trouble = std::move(error), .done = false, .again = false};
}
Attempt onceMore(core::Error error) {
    return {.shot = {}, .trouble = std::move(error), .done = false, .again = true};
}

core::Error absurdPoint(core::Duration waited) {
    const double waited_s = std::chrono::duration<double>(waited).count();
    return {.kind = core::ErrorKind::kAbsurdPoint,
            .happened = QObject::tr("No distance came back within %1 s; the shot was ended and is not used.")
                            .arg(waited_s, 0, 'f', 1),
            .remedy = QObject::tr("Aim beside the absorbing surface, come nearer, or use a prism."),
            .info_code = std::nullopt,
            .detail = {}};
}

core::Error oldDistance(const QString& reason) {
    return {.kind = core::ErrorKind::kAbsurdPoint,
            .happened = reason,
            .remedy = QObject::tr("Measure again."),
            .info_code = std::nullopt,
            .detail = {}};
}

/// Two masters: the other one measured or read the distance away while ours was awaited.
core::Error takenByPanel() {
    return {.kind = core::ErrorKind::kAbsurdPoint,
            .happened = QObject::tr("The panel measured or read at the same time and took the distance."),
            .remedy = QObject::tr("Measure again; for a while alone, take control with the control switch."),
            .info_code = std::nullopt,
            .detail = {}};
}

bool runsOn(EdmMode mode) { return averages(mode) || mode == EdmMode::kTrk; }

/// Ends a shot in the instrument: the page discloses no terminate command, so the mode is selected again
/// (4.7).
core::Task<void> terminate(StatePtr state) {
    state->distance_is_ours = false;
    auto selecting = selectMode(state, state->mode, {});
    const auto outcome = co_await selecting;
    if (!outcome) {
        qCInfo(core::logInstrument) << "the shot could not be ended:" << outcome.error().happened;
    }
}

/// A distance that waits in the instrument from before would be taken for ours: read it away. A mode that
/// measures on and on is ended first.
core::Task<core::Result<void>> discardEarlierDistance(StatePtr state, std::stop_token stop) {
    if (runsOn(state->mode) || !state->mode_selected) {
        auto selecting = selectMode(state, state->mode, stop);
        PMTS_CO_TRY(co_await selecting);
    }
    auto polling = pollDistance(state, stop);
    const auto outcome = co_await polling;
    const bool fatal =
        outcome.kind == PollKind::kFailed && !isLineTrouble(outcome.error) && !outcome.error.info_code;
    if (fatal) {
        co_return tl::unexpected(outcome.error);
    }
    state->distance_is_ours = outcome.kind != PollKind::kFailed && outcome.kind != PollKind::kDamaged;
    co_return {};
}

/// TG; its block end comes at once or with the distance.
core::Task<core::Result<void>> trigger(StatePtr state, core::Duration wait_limit, std::stop_token stop) {
    Question question = commandQuestion(*state, protocol::Trigger{});
    question.limit =
        state->trigger_answers_at_once ? std::min(state->settings.write_limit, wait_limit) : wait_limit;
    state->distance_is_ours = false;
    const auto began_at = state->clock.now();
    auto triggering = exchange(state, question, stop);
    const auto reply = co_await triggering;
    if (!reply) {
        co_return tl::unexpected(reply.error());
    }
    if (const auto error = commandError(checkBlock(*reply))) {
        co_return tl::unexpected(*error);
    }
    state->trigger_answers_at_once = state->clock.now() - began_at < kAtOnce;
    co_return {};
}

/// The distance as often alike as the line demands; a mode that measures on is averaged out before.
core::Task<core::Result<std::string>> confirmDistance(StatePtr state, std::string seen,
                                                      core::Duration began_at, std::stop_token stop) {
    if (averages(state->mode)) {
        const auto left = began_at + state->settings.averaging_time - state->clock.now();
        auto settling = watchAveraging(state, left, stop);
        PMTS_CO_TRY(co_await settling);
        auto ending =
            ask(state, commandQuestion(*state, protocol::Trigger{}), stop);  // the second TG ends it
        PMTS_CO_TRY(co_await ending);
        seen.clear();
    }
    auto confirming = readAgreedText(state, protocol::kSd, seen, stop);
    co_return co_await confirming;
}

/// The circles of the block against those before the trigger; what differs is read again.
core::Task<core::Result<geometry::Pointing>> confirmPointing(StatePtr state,
                                                             std::optional<geometry::Pointing> in_block,
                                                             geometry::Pointing before,
                                                             std::stop_token stop) {
    const Angle noise = state->settings.reading_noise;
    const auto alike = [noise](const geometry::Pointing& a, const geometry::Pointing& b) {
        return core::abs(circleDifference(a.ha, b.ha)) <= noise &&
               core::abs(circleDifference(a.va, b.va)) <= noise;
    };
    if (in_block && alike(*in_block, before)) {
        keepPointing(*state, *in_block);
        co_return *in_block;
    }
    auto reading = readVerifiedPointing(state, stop);
    auto now = co_await reading;
    if (now && in_block && alike(*in_block, *now)) {
        co_return *in_block;
    }
    co_return now;
}

bool sharedSince(const GeodimeterState& state, core::Duration at) {
    return state.foreign_command_at && *state.foreign_command_at >= at;
}

struct Found {
    std::string distance;
    std::optional<geometry::Pointing> pointing;
    std::string raw;
    core::Duration began_at{0};
    core::Duration arrived_at{0};
};

core::Task<Attempt> finishShot(StatePtr state, Found found, geometry::Pointing before, std::stop_token stop) {
    auto confirming = confirmDistance(state, found.distance, found.began_at, stop);
    const auto text = co_await confirming;
    if (!text && isClass(text.error(), InfoClass::kRemeasure) && sharedSince(*state, found.began_at)) {
        co_return onceMore(takenByPanel());
    }
    if (!text) {
        co_return isLineTrouble(text.error()) ? onceMore(text.error()) : failed(text.error());
    }
    auto reading = confirmPointing(state, found.pointing, before, stop);
    const auto pointing = co_await reading;
    if (!pointing) {
        co_return isLineTrouble(pointing.error()) ? onceMore(pointing.error()) : failed(pointing.error());
    }
    const auto distance_m = protocol::metresFromWire(*text, state->units->length);
    if (!distance_m || *distance_m <= 0.0) {
        co_return onceMore(oldDistance(QObject::tr("The instrument gave no usable distance.")));
    }
    if (state->settings.target_test.on && isOtherPoint(state->settings, before, *pointing, *distance_m)) {
        state->track.is_still = false;
        co_return failed(oldDistance(QObject::tr(
            "The instrument moved while it measured; the distance may belong to another point.")));
    }
    state->distance_is_ours = true;
    const auto taken = (averages(state->mode) ? state->clock.now() : found.arrived_at) - found.began_at;
    DistanceShot shot{
        .pointing = *pointing,
        .slope_distance_m = *distance_m,
        .mode = state->mode,
        .time_taken = taken,
        .measured_at = found.arrived_at,
        .utc = state->clock.utcNow(),
        .raw_reply = QString::fromLatin1(found.raw.data(), static_cast<qsizetype>(found.raw.size()))};
    co_return Attempt{.shot = std::move(shot), .trouble = {}, .done = true, .again = false};
}

struct Wait {
    core::Duration began_at{0};
    core::Duration latest{0};
    std::optional<core::Duration> soonest;  ///< after TG, by experience
};

/// Polls RG until the distance of this trigger is there.
core::Task<Attempt> awaitDistance(StatePtr state, Wait wait, geometry::Pointing before,
                                  std::stop_token stop) {
    PollJudge judge(*state);
    for (int polls = 0; polls < state->settings.max_polls; ++polls) {
        auto pausing = pauseBeforePoll(state, wait.began_at, wait.soonest, polls, stop);
        if (const auto paused = co_await pausing; !paused) {
            co_return failed(paused.error());
        }
        if (state->clock.now() >= wait.latest) {
            break;
        }
        auto polling = pollDistance(state, stop);
        auto outcome = co_await polling;
        const auto verdict = judge.judge(outcome, wait.began_at);
        if (verdict == PollVerdict::kFound) {
            Found found{.distance = outcome.distance,
                        .pointing = outcome.pointing,
                        .raw = outcome.raw,
                        .began_at = wait.began_at,
                        .arrived_at = state->clock.now()};
            auto finishing = finishShot(state, found, before, stop);
            co_return co_await finishing;
        }
        const bool may_be_taken = outcome.error.info_code && isClass(outcome.error, InfoClass::kRemeasure);
        if (verdict != PollVerdict::kGoOn && may_be_taken && sharedSince(*state, wait.began_at)) {
            co_return onceMore(takenByPanel());
        }
        if (verdict == PollVerdict::kAgain) {
            co_return onceMore(outcome.error);
        }
        if (verdict == PollVerdict::kFailed) {
            co_return failed(outcome.error);
        }
    }
    co_return sharedSince(*state, wait.began_at) ? onceMore(takenByPanel()) : failed(absurdPoint(state->clock.now() - wait.began_at));
}

core::Task<Attempt> shoot(StatePtr state, geometry::Pointing before, std::stop_token stop) {
    if (!state->distance_is_ours || !state->mode_selected || runsOn(state->mode)) {
        auto discarding = discardEarlierDistance(state, stop);
        if (const auto ready = co_await discarding; !ready) {
            co_return failed(ready.error());
        }
    }
    const auto wait_limit = learnedLimit(*state) + state->settings.extra_time;
    Wait wait{.began_at = state->clock.now(),
              .latest = state->clock.now() + wait_limit,
              .soonest = usualTime(*state, 0.05)};
    auto triggering = trigger(state, wait_limit, stop);
    const auto triggered = co_await triggering;
    const bool unanswered = !triggered && triggered.error().kind == core::ErrorKind::kTimeOut;
    if (unanswered && !state->trigger_answers_at_once) {
        co_return failed(absurdPoint(wait_limit));
    }
    if (!triggered) {
        const bool doubtful = state->quality.isNoisy() && triggered.error().info_code;
        const bool repeatable =
            doubtful || isLineTrouble(triggered.error()) || isClass(triggered.error(), InfoClass::kRemeasure);
        co_return repeatable ? onceMore(triggered.error()) : failed(triggered.error());
    }
    auto waiting = awaitDistance(state, wait, before, stop);
    co_return co_await waiting;
}

core::Task<core::Result<geometry::Pointing>> pointingBeforeShot(StatePtr state, std::stop_token stop) {
    if (state->track.is_still && state->track.ha && state->track.va) {
        co_return geometry::Pointing{.ha = *state->track.ha, .va = *state->track.va};
    }
    auto reading = readVerifiedPointing(state, stop);
    co_return co_await reading;
}

core::Task<core::Result<DistanceShot>> shootWithRetries(StatePtr state, std::stop_token stop) {
    auto reading = pointingBeforeShot(state, stop);
    const auto before = co_await reading;
    if (!before) {
        co_return tl::unexpected(before.error());
    }
    for (int attempt = 1;; ++attempt) {
        auto shooting = shoot(state, *before, stop);
        auto outcome = co_await shooting;
        if (outcome.done) {
            co_return outcome.shot;
        }
        const bool cancelled = outcome.trouble.kind == core::ErrorKind::kCancelled;
        if (!cancelled && !stop.stop_requested()) {
            auto terminating = terminate(state);
            co_await terminating;
        }
        const int most = state->quality.isNoisy()
                             ? std::max(kNoisyShotAttempts, state->settings.shot_attempts)
                             : state->settings.shot_attempts;
        if (!outcome.again || attempt >= most || stop.stop_requested()) {
            co_return tl::unexpected(std::move(outcome.trouble));
        }
    }
}

}  // namespace

bool isOtherPoint(const GeodimeterSettings& settings, const geometry::Pointing& before,
                  const geometry::Pointing& after, double slope_distance_m) {
    constexpr double kProportionalBeyond_m = 400.0;
    const Angle ha = circleDifference(after.ha, before.ha) * core::sin(after.va);
    const Angle va = circleDifference(after.va, before.va);
    const double moved_rad = std::hypot(ha.rad(), va.rad());
    const double allowed_m =
        settings.target_test.offset_m * std::max(1.0, slope_distance_m / kProportionalBeyond_m);
    return moved_rad > settings.target_test.angle.rad() || moved_rad * slope_distance_m > allowed_m;
}

core::Task<core::Result<void>> selectMode(StatePtr state, EdmMode mode, std::stop_token stop) {
    state->mode_selected = false;
    const protocol::Command command = protocol::SetMode{.mode = mode};
    auto selecting = ask(state, commandQuestion(*state, command), stop);
    PMTS_CO_TRY(co_await selecting);
    state->mode = mode;
    state->mode_selected = true;
    co_return {};
}

core::Task<core::Result<DistanceShot>> measure(StatePtr state, std::stop_token stop) {
    if (const auto refused = refusal(*state, true)) {
        co_return tl::unexpected(*refused);
    }
    const auto usual = usualTime(*state, 0.5).value_or(timingOf(*state).initial_limit);
    const Routine routine(state, Activity::kMeasuring, stop, usual);
    if (!state->mode_selected) {
        auto selecting = selectMode(state, state->mode, routine.token());
        PMTS_CO_TRY(co_await selecting);
    }
    state->warnings.beginMeasurement();
    auto shooting = shootWithRetries(state, routine.token());
    auto outcome = co_await shooting;
    if (outcome) {
        state->warnings.endMeasurement();
        state->statistics.add(timingKey(outcome->mode, outcome->slope_distance_m), outcome->time_taken);
    } else if (outcome.error().kind == core::ErrorKind::kCancelled) {
        sendStop(state);
    }
    if (outcome && runsOn(state->mode)) {
        auto ending = selectMode(state, state->mode, routine.token());
        [[maybe_unused]] const auto ended =
            co_await ending;  // if it failed, it is selected before the next shot
    }
    co_return outcome;
}

}  // namespace pmts::instrument
