#include "readings.hpp"

#include "pmts/protocol/labels.hpp"

#include <algorithm>
#include <map>

namespace pmts::instrument {
namespace {

constexpr int kReadingsBeyondAgreement = 40;
/// Faster than any of these instruments turns; a lost whole digit moves a reading by nine units and more.
constexpr double kFastestGonPerSecond = 80.0;
constexpr core::Angle kLargestStep = core::Angle::fromGon(5);

core::Error unreliable(const QString& what) {
    return {.kind = core::ErrorKind::kProtocol,
            .happened = QObject::tr("%1 could not be read reliably: the line loses bytes.").arg(what),
            .remedy = QObject::tr("Check cable and plugs, then repeat."),
            .info_code = std::nullopt,
            .detail = {}};
}

bool isNumeric(int label) {
    const auto* known = protocol::findLabel(label);
    return known != nullptr && known->kind == protocol::LabelKind::kDecimal;
}

/// Whether the instrument can have turned from one reading to the other.
bool fitsMotion(const GeodimeterState& state, core::Angle from, core::Angle to, core::Duration span) {
    const auto way = core::Angle::fromGon(kFastestGonPerSecond * std::chrono::duration<double>(span).count());
    return core::abs(circleDifference(to, from)) <=
           std::min(state.settings.reading_noise + way, kLargestStep);
}

int alike(const std::vector<core::Angle>& readings, core::Angle value, core::Angle noise) {
    return static_cast<int>(std::ranges::count_if(
        readings, [&](core::Angle other) { return core::abs(circleDifference(other, value)) <= noise; }));
}

/// By how many readings this value leads over the most frequent one that is not alike.
int leadOf(const std::vector<core::Angle>& readings, core::Angle value, core::Angle noise) {
    int most_other = 0;
    for (const core::Angle other : readings) {
        if (core::abs(circleDifference(other, value)) > noise) {
            most_other = std::max(most_other, alike(readings, other, noise));
        }
    }
    return alike(readings, value, noise) - most_other;
}

int leadOf(const std::map<std::string, int>& seen, const std::string& text) {
    int most_other = 0;
    for (const auto& [other, count] : seen) {
        most_other = other == text ? most_other : std::max(most_other, count);
    }
    return seen.at(text) - most_other;
}

/// One axis of a poll: the new value when it fits, or when it confirms an earlier doubtful one.
bool takesReading(const GeodimeterState& state, std::optional<core::Angle>& kept,
                  std::optional<core::Angle>& doubtful, core::Angle value) {
    const auto span = state.clock.now() - state.track.at;
    const bool confirmed = doubtful && fitsMotion(state, *doubtful, value, span);
    if (!confirmed && (!kept || !fitsMotion(state, *kept, value, span))) {
        doubtful = value;
        return false;
    }
    doubtful.reset();
    kept = value;
    return true;
}

core::Task<core::Result<core::Angle>> pollCircle(StatePtr state, int label, std::stop_token stop) {
    Question question = labelQuestion(*state, label);
    question.priority = scheduler::Priority::kPoll;
    auto asking = exchange(state, question, stop);
    const auto reply = co_await asking;
    if (!reply) {
        co_return tl::unexpected(reply.error());
    }
    const auto block = checkBlock(*reply);
    if (const auto error = deviceError(block)) {
        co_return tl::unexpected(*error);
    }
    const auto* text = block.find(label);
    if (text == nullptr || !isBelievableNumber(*state, label, *text)) {
        co_return tl::unexpected(unreliable(QObject::tr("The pointing")));
    }
    co_return circleAngle(*state, *text);
}

void report(const GeodimeterState& state) {
    if (state.front != nullptr && state.front->on_pointing && state.track.ha && state.track.va) {
        state.front->on_pointing({.ha = *state.track.ha, .va = *state.track.va}, state.track.at);
    }
}

}  // namespace

bool UsualDecimals::believe(int decimals) {
    if (!usual_ || decimals == *usual_) {
        usual_ = decimals;
        in_row_ = 0;
        return true;
    }
    in_row_ = decimals == other_ ? in_row_ + 1 : 1;
    other_ = decimals;
    if (in_row_ < kInRowToChange) {
        return false;
    }
    usual_ = decimals;
    in_row_ = 0;
    return true;
}

bool isBelievableNumber(GeodimeterState& state, int decimals_key, std::string_view text) {
    const auto decimals = decimalsOf(text);
    return decimals && state.decimals[decimals_key].believe(*decimals);
}

core::Angle circleDifference(core::Angle a, core::Angle b) { return core::normalizedSigned(a - b); }

core::Result<core::Angle> circleAngle(const GeodimeterState& state, std::string_view text) {
    if (!state.units) {
        return tl::unexpected(unitsUnknownError());
    }
    return protocol::angleFromWire(text, state.units->angle);
}

core::Task<core::Result<std::string>> readText(StatePtr state, int label, std::stop_token stop) {
    const bool numeric = isNumeric(label);
    for (int i = 0; i < kReadingsBeyondAgreement; ++i) {
        auto asking = ask(state, labelQuestion(*state, label), stop);
        const auto block = co_await asking;
        if (!block) {
            co_return tl::unexpected(block.error());
        }
        const auto* text = block->find(label);
        if (text != nullptr && (!numeric || isBelievableNumber(*state, label, *text))) {
            co_return *text;
        }
        state->quality.trouble();
    }
    co_return tl::unexpected(unreliable(QObject::tr("Label %1").arg(label)));
}

core::Task<core::Result<std::string>> readAgreedText(StatePtr state, int label, std::string already,
                                                     std::stop_token stop) {
    std::map<std::string, int> seen;
    if (!already.empty()) {
        seen[already] = 1;
    }
    const int most = state->quality.leadNeeded() + kReadingsBeyondAgreement;
    for (int i = 0; i < most; ++i) {
        auto reading = readText(state, label, stop);
        auto text = co_await reading;
        if (!text) {
            co_return text;
        }
        ++seen[*text];
        if (seen.size() > 1) {
            state->quality.trouble();
        }
        if (leadOf(seen, *text) >= state->quality.leadNeeded()) {
            co_return text;
        }
    }
    co_return tl::unexpected(unreliable(QObject::tr("Label %1").arg(label)));
}

core::Task<core::Result<core::Angle>> readAngle(StatePtr state, int label,
                                                std::optional<core::Angle> expected, core::Angle within,
                                                std::stop_token stop) {
    std::vector<core::Angle> readings;
    const core::Angle noise = state->settings.reading_noise;
    const int most = state->quality.leadNeeded() + kReadingsBeyondAgreement;
    for (int i = 0; i < most; ++i) {
        auto reading = readText(state, label, stop);
        const auto text = co_await reading;
        if (!text) {
            co_return tl::unexpected(text.error());
        }
        const auto angle = circleAngle(*state, *text);
        if (!angle) {
            state->quality.trouble();
            continue;
        }
        readings.push_back(*angle);
        const bool as_expected = expected && core::abs(circleDifference(*angle, *expected)) <= within;
        if (as_expected || leadOf(readings, *angle, noise) >= state->quality.leadNeeded()) {
            co_return *angle;
        }
    }
    co_return tl::unexpected(unreliable(QObject::tr("The pointing")));
}

core::Task<core::Result<geometry::Pointing>> readVerifiedPointing(StatePtr state, std::stop_token stop) {
    const core::Angle noise = state->settings.reading_noise;
    auto reading_ha = readAngle(state, protocol::kHa, state->track.ha, noise, stop);
    const auto ha = co_await reading_ha;
    if (!ha) {
        co_return tl::unexpected(ha.error());
    }
    auto reading_va = readAngle(state, protocol::kVa, state->track.va, noise, stop);
    const auto va = co_await reading_va;
    if (!va) {
        co_return tl::unexpected(va.error());
    }
    const geometry::Pointing pointing{.ha = *ha, .va = *va};
    keepPointing(*state, pointing);
    co_return pointing;
}

core::Task<core::Result<geometry::Pointing>> pollCircles(StatePtr state, std::stop_token stop) {
    auto polling_ha = pollCircle(state, protocol::kHa, stop);
    const auto ha = co_await polling_ha;
    if (!ha) {
        co_return tl::unexpected(ha.error());
    }
    auto polling_va = pollCircle(state, protocol::kVa, stop);
    const auto va = co_await polling_va;
    if (!va) {
        co_return tl::unexpected(va.error());
    }
    notePointing(*state, *ha, *va);
    if (!state->track.ha || !state->track.va) {
        co_return tl::unexpected(unreliable(QObject::tr("The pointing")));
    }
    co_return geometry::Pointing{.ha = *state->track.ha, .va = *state->track.va};
}

void keepPointing(GeodimeterState& state, const geometry::Pointing& pointing) {
    state.track.ha = pointing.ha;
    state.track.va = pointing.va;
    state.track.doubtful_ha.reset();
    state.track.doubtful_va.reset();
    state.track.at = state.clock.now();
    report(state);
}

void notePointing(GeodimeterState& state, std::optional<core::Angle> ha, std::optional<core::Angle> va) {
    auto& track = state.track;
    const auto before = std::pair(track.ha, track.va);
    const bool ha_taken = ha && takesReading(state, track.ha, track.doubtful_ha, *ha);
    const bool va_taken = va && takesReading(state, track.va, track.doubtful_va, *va);
    if (!ha_taken && !va_taken) {
        return;
    }
    const auto moved = [&](const auto& now, const auto& then) {
        return !then || core::abs(circleDifference(*now, *then)) > state.settings.reading_noise;
    };
    if ((ha_taken && moved(track.ha, before.first)) || (va_taken && moved(track.va, before.second))) {
        track.is_still = false;
    }
    track.at = state.clock.now();
    report(state);
}

}  // namespace pmts::instrument
