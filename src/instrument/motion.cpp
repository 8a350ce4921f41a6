#include "motion.hpp"

#include "pmts/core/angle_text.hpp"
#include "pmts/protocol/labels.hpp"
#include "readings.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::instrument {
namespace {

using namespace std::chrono_literals;
using core::Angle;
using protocol::InfoClass;

constexpr int kLargestToleranceCc = 99;
/// Read back against written: half a second of arc of rounding in DMS, and a hair.
constexpr Angle kReadBackRounding = Angle::fromCc(4);
constexpr int kTargetAttempts = 4;
/// The mean of a few readings is better than one; its own doubt.
constexpr int kArrivalReadings = 5;
constexpr Angle kMeanDoubt = Angle::fromCc(4);
constexpr core::Duration kStillInterval = 200ms;
constexpr core::Duration kMotionDoubt = 2s;
constexpr int kMotionsToLearn = 3;

QString angleText(Angle angle) { return core::angleText(angle, core::AngleUnit::kGon, 4); }

core::Error notReached(const QString& residuals, const std::optional<core::Error>& soft) {
    const QString happened = QObject::tr("The instrument stopped beside its target (%1).").arg(residuals);
    return {.kind = core::ErrorKind::kNotReached,
            .happened = happened,
            .remedy = soft ? soft->remedy
                           : QObject::tr("Let it settle, or allow a larger tolerance, and turn again."),
            .info_code = soft ? soft->info_code : std::nullopt,
            .detail = soft ? soft->happened : QString()};
}

core::Error targetNotTaken(const QString& axis) {
    return {.kind = core::ErrorKind::kProtocol,
            .happened =
                QObject::tr("The instrument did not keep the %1 target; it has not been turned.").arg(axis),
            .remedy = QObject::tr("Check cable and plugs, then turn again."),
            .info_code = std::nullopt,
            .detail = {}};
}

/// Clockwise from min to max, 0 gon may lie in between.
bool isInSector(Angle ha, Angle min, Angle max) {
    return core::normalized(ha - min).gon() <= core::normalized(max - min).gon();
}

Angle wayTo(const GeodimeterState& state, const TurnTarget& target) {
    Angle way;
    if (target.ha) {
        way = state.track.ha ? core::abs(circleDifference(*target.ha, *state.track.ha)) : Angle::fromGon(200);
    }
    if (target.va) {
        const Angle va_way = state.track.va ? core::abs(*target.va - *state.track.va) : Angle::fromGon(200);
        way = std::max(way, va_way);
    }
    return way;
}

/// Whether RG,label shows the angle just written; absent when the instrument does not show that label.
core::Task<core::Result<std::optional<bool>>> showsTarget(StatePtr state, int label, Angle target,
                                                          std::stop_token stop) {
    for (int i = 0; i < 2; ++i) {
        auto asking = ask(state, labelQuestion(*state, label), stop);
        const auto block = co_await asking;
        if (!block && isClass(block.error(), InfoClass::kProtocol)) {
            state->targets_readable = false;
            co_return std::optional<bool>();
        }
        if (!block) {
            co_return tl::unexpected(block.error());
        }
        const auto* text = block->find(label);
        const auto angle = text != nullptr ? circleAngle(*state, *text) : tl::unexpected(core::Error{});
        if (angle && core::abs(circleDifference(*angle, target)) <= kReadBackRounding) {
            co_return std::optional(true);
        }
        state->quality.trouble();  // written or shown wrong: ask once more before writing again
    }
    co_return std::optional(false);
}

core::Task<core::Result<void>> writeTarget(StatePtr state, int label, Angle target, std::stop_token stop) {
    const auto text = protocol::wireAngle(target, state->units->angle, state->settings.angle_decimals);
    const protocol::Command command = protocol::WriteLabel{.label = label, .data = text};
    for (int i = 0; i < kTargetAttempts; ++i) {
        auto writing = ask(state, commandQuestion(*state, command), stop);
        PMTS_CO_TRY(co_await writing);
        if (!state->settings.read_back_targets || !state->targets_readable) {
            co_return {};
        }
        auto checking = showsTarget(state, label, target, stop);
        const auto shown = co_await checking;
        if (!shown) {
            co_return tl::unexpected(shown.error());
        }
        if (shown->value_or(true)) {
            co_return {};
        }
    }
    co_return tl::unexpected(
        targetNotTaken(label == protocol::kTargetHa ? QStringLiteral("HA") : QStringLiteral("VA")));
}

core::Task<core::Result<void>> writeTargets(StatePtr state, TurnTarget target, std::stop_token stop) {
    if (target.va) {
        auto writing = writeTarget(state, protocol::kTargetVa, *target.va, stop);
        PMTS_CO_TRY(co_await writing);
    }
    if (target.ha) {
        auto writing = writeTarget(state, protocol::kTargetHa, *target.ha, stop);
        PMTS_CO_TRY(co_await writing);
    }
    co_return {};
}

Question positionQuestion(const GeodimeterState& state, const TurnTarget& target, core::Duration limit) {
    const int cc = std::clamp(static_cast<int>(std::lround(target.tolerance.cc())), 1, kLargestToleranceCc);
    protocol::Position position;
    position.ha_tolerance_cc = target.ha ? std::optional(cc) : std::nullopt;
    position.va_tolerance_cc = target.va ? std::optional(cc) : std::nullopt;
    Question question = commandQuestion(state, position);
    question.limit = limit;
    return question;
}

/// Once the profile's speed is seen to be right, a block end that stays away is a lost one.
core::Duration motionLimit(const GeodimeterState& state, core::Duration usual) {
    const bool known = state.motions_as_expected >= kMotionsToLearn;
    return known ? std::min(usual + state.settings.motion_limit, 2 * usual + 2 * kMotionDoubt)
                 : usual + state.settings.motion_limit;
}

/// The motors run until the block end. Asked once only: whether it is repeated depends on where the telescope
/// stands.
core::Task<core::Result<void>> runMotors(StatePtr state, TurnTarget target, std::stop_token stop) {
    const auto usual = motionTime(state->settings, wayTo(*state, target));
    state->track.is_still = false;
    const auto began_at = state->clock.now();
    auto moving = exchange(state, positionQuestion(*state, target, motionLimit(*state, usual)), stop);
    const auto reply = co_await moving;
    const bool as_expected = reply && state->clock.now() - began_at <= usual + kMotionDoubt;
    state->motions_as_expected = as_expected ? state->motions_as_expected + 1 : 0;
    if (!reply) {
        co_return tl::unexpected(reply.error());
    }
    if (const auto error = commandError(checkBlock(*reply))) {
        co_return tl::unexpected(*error);
    }
    co_return {};
}

struct Arrival {
    std::optional<Angle> reading;
    bool is_there = false;
    Angle residual;
};

core::Task<core::Result<Arrival>> checkAxis(StatePtr state, int label, Angle target, Angle tolerance,
                                            std::stop_token stop) {
    Angle sum;
    Arrival arrival;
    for (int i = 1; i <= kArrivalReadings; ++i) {
        auto reading = readAngle(state, label, target, tolerance, stop);
        const auto angle = co_await reading;
        if (!angle) {
            co_return tl::unexpected(angle.error());
        }
        const Angle off = circleDifference(*angle, target);
        sum += off;
        arrival.reading = *angle;
        arrival.residual = sum / i;
        const Angle allowed = i == 1 ? tolerance : tolerance + kMeanDoubt;
        arrival.is_there = core::abs(arrival.residual) <= allowed;
        if (arrival.is_there || core::abs(off) > tolerance + 2 * state->settings.reading_noise) {
            break;
        }
    }
    co_return arrival;
}

QString residualText(const char* axis, Angle residual) {
    return QObject::tr("%1 is off by %2 cc").arg(QLatin1String(axis)).arg(std::lround(residual.cc()));
}

core::Task<core::Result<geometry::Pointing>> verifyArrival(StatePtr state, TurnTarget target,
                                                           std::optional<core::Error> soft,
                                                           std::stop_token stop) {
    const Angle noise = state->settings.reading_noise;
    const auto within = [&](const std::optional<Angle>& turned) { return turned ? target.tolerance : noise; };
    const Angle wanted_ha = target.ha.value_or(state->track.ha.value_or(Angle()));
    auto checking_ha = checkAxis(state, protocol::kHa, wanted_ha, within(target.ha), stop);
    const auto ha = co_await checking_ha;
    if (!ha) {
        co_return tl::unexpected(ha.error());
    }
    const Angle wanted_va = target.va.value_or(state->track.va.value_or(Angle()));
    auto checking_va = checkAxis(state, protocol::kVa, wanted_va, within(target.va), stop);
    const auto va = co_await checking_va;
    if (!va) {
        co_return tl::unexpected(va.error());
    }
    const geometry::Pointing pointing{.ha = *ha->reading, .va = *va->reading};
    keepPointing(*state, pointing);
    QStringList residuals;
    if (target.ha && !ha->is_there) {
        residuals << residualText("HA", ha->residual);
    }
    if (target.va && !va->is_there) {
        residuals << residualText("VA", va->residual);
    }
    if (!residuals.isEmpty()) {
        co_return tl::unexpected(notReached(residuals.join(QStringLiteral(", ")), soft));
    }
    state->track.is_still = true;
    co_return pointing;
}

/// The block end was lost or is not sent at all (label 79 = 0): the circles say when the motors have stopped.
core::Task<core::Result<void>> waitUntilStill(StatePtr state, TurnTarget target, std::stop_token stop) {
    const auto latest = state->clock.now() + motionTime(state->settings, wayTo(*state, target)) +
                        state->settings.motion_limit;
    std::optional<geometry::Pointing> before;
    while (state->clock.now() < latest) {
        auto reading = readVerifiedPointing(state, stop);
        const auto now = co_await reading;
        if (!now && !isLineTrouble(now.error())) {
            co_return tl::unexpected(now.error());
        }
        const Angle noise = state->settings.reading_noise;
        if (now && before && core::abs(circleDifference(now->ha, before->ha)) <= noise &&
            core::abs(circleDifference(now->va, before->va)) <= noise) {
            co_return {};
        }
        before = now ? std::optional(*now) : std::nullopt;
        auto pause = core::sleepFor(state->clock, kStillInterval, stop);
        PMTS_CO_TRY(co_await pause);
    }
    co_return {};
}

/// One way of the motors, from the targets to the verified arrival.
core::Task<core::Result<geometry::Pointing>> turnOnce(StatePtr state, TurnTarget target,
                                                      std::stop_token stop) {
    auto writing = writeTargets(state, target, stop);
    PMTS_CO_TRY(co_await writing);
    auto running = runMotors(state, target, stop);
    const auto moved = co_await running;
    std::optional<core::Error> soft;
    const bool lost = !moved && moved.error().kind == core::ErrorKind::kTimeOut;
    if (!moved && isClass(moved.error(), InfoClass::kMotionSoft)) {
        soft = moved.error();
    } else if (!moved && !lost) {
        co_return tl::unexpected(moved.error());
    }
    if (lost) {
        auto settling = settleLine(state, stop);
        const bool answers = co_await settling;
        if (!answers) {
            co_return tl::unexpected(moved.error());
        }
    }
    if (lost || !state->line || !state->line->endMark()) {
        auto waiting = waitUntilStill(state, target, stop);
        PMTS_CO_TRY(co_await waiting);
    }
    auto verifying = verifyArrival(state, target, soft, stop);
    co_return co_await verifying;
}

/// A refusal is believed at the second time, unless the line is known to lose bytes.
int mostRetries(const GeodimeterState& state, const core::Error& error) {
    return isClass(error, InfoClass::kProtocol) && !state.quality.isNoisy() ? 1 : patience(state);
}

/// On a line that loses bytes no other info code of a motion is believed at once: `30` may read `3`, `161`
/// may read `16`.
bool isDoubtful(const GeodimeterState& state, const core::Error& error) {
    const bool of_a_motion = isClass(error, InfoClass::kMotion) || isClass(error, InfoClass::kTarget);
    return isLineTrouble(error) || (state.quality.isNoisy() && error.info_code && !of_a_motion);
}

/// Page 2.10: motion-soft once with wider tolerance, comm and retry up to `retries` times, the rest goes up.
core::Task<core::Result<geometry::Pointing>> turnWithRetries(StatePtr state, TurnTarget target,
                                                             std::stop_token stop) {
    int soft_left = state->settings.soft_retries;
    for (int line_trouble = 0;;) {
        auto turning = turnOnce(state, target, stop);
        auto outcome = co_await turning;
        if (outcome || stop.stop_requested()) {
            co_return outcome;
        }
        const bool beside = outcome.error().kind == core::ErrorKind::kNotReached;
        if (beside && soft_left-- > 0) {
            target.tolerance = outcome.error().info_code ? 2 * target.tolerance : target.tolerance;
        } else if (!beside && isDoubtful(*state, outcome.error()) &&
                   line_trouble++ < mostRetries(*state, outcome.error())) {
            auto settling = settleLine(state, stop);
            const bool answers = co_await settling;
            if (!answers) {
                co_return outcome;
            }
        } else {
            co_return outcome;
        }
    }
}

std::optional<core::Error> limitError(const QString& axis, Angle wanted, Angle min, Angle max) {
    return core::Error{
        .kind = core::ErrorKind::kLimit,
        .happened = QObject::tr("%1 %2 is outside the motion limits (%3 to %4).")
                        .arg(axis, angleText(wanted), angleText(min), angleText(max)),
        .remedy = QObject::tr("Choose another target, or change the limits in the instrument's profile."),
        .info_code = std::nullopt,
        .detail = {}};
}

}  // namespace

core::Duration motionTime(const GeodimeterSettings& settings, Angle way) {
    const double gon = std::abs(way.gon());
    const double ramp_gon = settings.speed_gon_s * settings.speed_gon_s / settings.acceleration_gon_s2;
    const double seconds =
        gon < ramp_gon ? 2.0 * std::sqrt(gon / settings.acceleration_gon_s2)
                       : gon / settings.speed_gon_s + settings.speed_gon_s / settings.acceleration_gon_s2;
    return std::chrono::duration_cast<core::Duration>(std::chrono::duration<double>(seconds)) +
           settings.settle;
}

std::optional<core::Error> outsideLimits(const GeodimeterSettings& settings, const TurnTarget& target) {
    if (target.va && (*target.va < settings.va_min || *target.va > settings.va_max)) {
        return limitError(QStringLiteral("VA"), *target.va, settings.va_min, settings.va_max);
    }
    if (target.ha && settings.ha_min && settings.ha_max &&
        !isInSector(*target.ha, *settings.ha_min, *settings.ha_max)) {
        return limitError(QStringLiteral("HA"), *target.ha, *settings.ha_min, *settings.ha_max);
    }
    return std::nullopt;
}

core::Task<core::Result<geometry::Pointing>> turn(StatePtr state, TurnTarget target, std::stop_token stop) {
    if (const auto refused = refusal(*state, true)) {
        co_return tl::unexpected(*refused);
    }
    if (target.ha) {
        target.ha = core::normalized(*target.ha);
    }
    if (const auto outside = outsideLimits(state->settings, target)) {
        co_return tl::unexpected(*outside);
    }
    const Routine routine(state, Activity::kTurning, stop,
                          motionTime(state->settings, wayTo(*state, target)));
    auto turning = turnWithRetries(state, target, routine.token());
    auto outcome = co_await turning;
    if (!outcome && outcome.error().kind == core::ErrorKind::kCancelled) {
        sendStop(state);
    }
    co_return outcome;
}

}  // namespace pmts::instrument
