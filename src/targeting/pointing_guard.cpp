#include "pmts/targeting/pointing_guard.hpp"

#include "pmts/geometry/polar.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pmts::targeting {
namespace {

using core::Angle;
using core::ErrorKind;
using core::Result;
using geometry::Pointing;

/// The Sun is up, or so little below the horizon that refraction lifts it.
const Angle kSunset = Angle::fromDeg(90.9);

QString sentence(const char* text) { return QCoreApplication::translate("PointingGuard", text); }

QString gon(Angle angle) { return QString::number(angle.gon(), 'f', 1); }

tl::unexpected<core::Error> refuse(const QString& happened, const QString& remedy, const char* detail) {
    return core::fail(ErrorKind::kLimit, happened, remedy, QString::fromLatin1(detail));
}

Angle zenithAngle(const Pointing& pointing) {
    const Angle va = core::normalized(pointing.va);
    return va.gon() > 200.0 ? Angle::fromGon(400) - va : va;
}

/// VA through the zenith, so that a change of face is one way: -100 gon is VA 300.
Angle throughZenith(Angle va) { return core::normalizedSigned(va); }

/// The way both motors make at one speed: the shorter axis stops first. `share` of the longer one's time.
Pointing onTheWay(const Pointing& from, Angle turn, Angle tilt, double share) {
    const Angle longest = std::max(core::abs(turn), core::abs(tilt));
    const auto part = [&](Angle way) {
        const double size = std::min(std::abs(way.gon()), share * longest.gon());
        return Angle::fromGon(std::copysign(size, way.gon()));
    };
    return {core::normalized(from.ha + part(turn)), core::normalized(throughZenith(from.va) + part(tilt))};
}

bool isBetween(Angle ha, const std::pair<Angle, Angle>& sector) {
    return core::normalized(ha - sector.first) <= core::normalized(sector.second - sector.first);
}

}  // namespace

PointingGuard::PointingGuard(const core::Clock& clock, PointingGuardSettings settings)
    : clock_(clock), settings_(std::move(settings)) {}

Result<void> PointingGuard::check(const Pointing& from, const Pointing& to) const {
    PMTS_TRY(checkLimits(to));
    PMTS_TRY(checkCable(from, to));
    return checkSun(from, to);
}

Result<void> PointingGuard::checkStanding(const Pointing& at) const { return checkSun(at, at); }

Result<void> PointingGuard::checkLimits(const Pointing& to) const {
    const MotionLimits& limits = settings_.limits;
    const Angle zenith = zenithAngle(to);
    if (zenith < limits.highest) {
        return refuse(sentence("The target is %1 gon from the zenith, above the motion limit of %2 gon.")
                          .arg(gon(zenith), gon(limits.highest)),
                      sentence("Choose a lower target or change the limit."), "high");
    }
    if (zenith > limits.lowest) {
        return refuse(sentence("The target is %1 gon from the zenith, below the motion limit of %2 gon.")
                          .arg(gon(zenith), gon(limits.lowest)),
                      sentence("Choose a higher target or change the limit."), "low");
    }
    if (!limits.face_two_allowed && geometry::isFaceTwo({to.ha, core::normalized(to.va)})) {
        return refuse(
            sentence("Face II is barred by the motion limits: the camera would hit the instrument."),
            sentence("Measure in face I or take the camera off."), "face");
    }
    if (limits.ha_sector && !isBetween(to.ha, *limits.ha_sector)) {
        return refuse(sentence("HA %1 gon is outside the sector from %2 to %3 gon.")
                          .arg(gon(core::normalized(to.ha)), gon(limits.ha_sector->first),
                               gon(limits.ha_sector->second)),
                      sentence("Choose a target inside it or change the sector."), "sector");
    }
    return {};
}

Result<void> PointingGuard::checkCable(const Pointing& from, const Pointing& to) const {
    if (!settings_.most_wound || !wound_) {
        return {};
    }
    const Angle after = *wound_ + core::normalizedSigned(to.ha - from.ha);
    const bool winds_on = core::abs(after) > core::abs(*wound_);
    if (winds_on && core::abs(after) > *settings_.most_wound) {
        return refuse(sentence("The move would wind the cable to %1 turns; %2 are allowed.")
                          .arg(std::abs(after.gon()) / 400.0, 0, 'f', 2)
                          .arg(settings_.most_wound->gon() / 400.0, 0, 'f', 2),
                      sentence("Turn the other way round, which unwinds it."), "cable");
    }
    return {};
}

Result<void> PointingGuard::checkSun(const Pointing& from, const Pointing& to) const {
    if (!settings_.sun) {
        return {};
    }
    constexpr double kLook_gon = 0.5;
    const SunGuard& guard = *settings_.sun;
    const SunPosition sun = sunPosition(guard.place, clock_.utcNow());
    if (sun.zenith_angle > kSunset) {
        return {};
    }
    const Pointing sun_at{core::normalized(sun.azimuth - guard.azimuth_of_zero), sun.zenith_angle};
    const Angle distance_from = geometry::separation(from, sun_at);
    const Angle turn = core::normalizedSigned(to.ha - from.ha);
    const Angle tilt = throughZenith(to.va) - throughZenith(from.va);
    const double way_gon = std::max(std::abs(turn.gon()), std::abs(tilt.gon()));
    const int looks = std::max(1, static_cast<int>(std::ceil(way_gon / kLook_gon)));
    for (int i = 1; i <= looks; ++i) {
        const Angle distance =
            geometry::separation(onTheWay(from, turn, tilt, static_cast<double>(i) / looks), sun_at);
        const bool leaves = distance_from < guard.cone && distance >= distance_from && way_gon > 0;
        if (distance < guard.cone && !leaves) {
            return i == looks
                       ? refuse(sentence("The target is %1 gon from the Sun, which would blind the camera.")
                                    .arg(gon(distance)),
                                sentence("Wait until the Sun has moved on, or cover the lenses."), "sun")
                       : refuse(
                             sentence("The way to the target passes the Sun at %1 gon.").arg(gon(distance)),
                             sentence("Go round it with a move in between."), "sun on the way");
        }
    }
    return {};
}

void PointingGuard::follow(const Pointing& at) {
    // In face II the alidade stands where the circle says; plunging does not turn it.
    wound_ = wound_.value_or(Angle()) + (last_ha_ ? core::normalizedSigned(at.ha - *last_ha_) : Angle());
    last_ha_ = at.ha;
}

std::vector<Pointing> PointingGuard::longWay(const Pointing& from, const Pointing& to) {
    const Angle short_way = core::normalizedSigned(to.ha - from.ha);
    const Angle long_way = short_way - Angle::fromGon(std::copysign(400.0, short_way.gon()));
    constexpr int kLegs = 3;  // each below half a turn, so that the short way of a leg is its direction
    std::vector<Pointing> legs;
    for (int i = 1; i < kLegs; ++i) {
        const double share = static_cast<double>(i) / kLegs;
        legs.push_back({core::normalized(from.ha + long_way * share),
                        core::normalized(throughZenith(from.va) +
                                         (throughZenith(to.va) - throughZenith(from.va)) * share)});
    }
    legs.push_back(to);
    return legs;
}

QString PointingGuard::sunSleeps() const {
    return settings_.sun
               ? QString()
               : sentence("The Sun is not watched: place and orientation of the station are needed.");
}

}  // namespace pmts::targeting
