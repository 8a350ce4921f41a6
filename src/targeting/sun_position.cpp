#include "pmts/targeting/sun_position.hpp"

#include <QTimeZone>

#include <algorithm>
#include <cmath>

namespace pmts::targeting {
namespace {

using core::Angle;

Angle deg(double degrees) { return Angle::fromDeg(degrees); }

/// Days from noon of 1 January 2000, UTC. Terrestrial time is a minute ahead: 0.001 degrees of the Sun's way.
double daysSince2000(const QDateTime& utc) {
    static const QDateTime epoch(QDate(2000, 1, 1), QTime(12, 0), QTimeZone::utc());
    return static_cast<double>(epoch.msecsTo(utc)) / 86'400'000.0;
}

/// The Sun on the celestial sphere.
struct Equatorial {
    Angle right_ascension, declination;
};

Equatorial apparentSun(double days) {
    const double t = days / 36525.0;
    const Angle mean_longitude = deg(280.46646 + t * (36000.76983 + 0.0003032 * t));
    const Angle anomaly = deg(357.52911 + t * (35999.05029 - 0.0001537 * t));
    const Angle centre =
        deg((1.914602 - t * (0.004817 + 0.000014 * t)) * core::sin(anomaly) +
            (0.019993 - 0.000101 * t) * core::sin(2 * anomaly) + 0.000289 * core::sin(3 * anomaly));
    const Angle node = deg(125.04 - 1934.136 * t);
    const Angle longitude = mean_longitude + centre - deg(0.00569 + 0.00478 * core::sin(node));
    const Angle obliquity =
        deg(23.4392911 - t * (0.0130042 + t * (1.64e-7 - 5.04e-7 * t)) + 0.00256 * core::cos(node));
    return {Angle::fromRad(std::atan2(core::cos(obliquity) * core::sin(longitude), core::cos(longitude))),
            Angle::fromRad(std::asin(core::sin(obliquity) * core::sin(longitude)))};
}

/// Greenwich mean sidereal time (Meeus 12.4).
Angle siderealTime(double days) {
    const double t = days / 36525.0;
    return deg(280.46061837 + 360.98564736629 * days + 0.000387933 * t * t);
}

}  // namespace

SunPosition sunPosition(const Place& place, const QDateTime& utc) {
    const double days = daysSince2000(utc);
    const Equatorial sun = apparentSun(days);
    const Angle hour = core::normalized(siderealTime(days)) + place.longitude - sun.right_ascension;
    const double south = core::cos(sun.declination) * core::cos(hour) * core::sin(place.latitude) -
                         core::sin(sun.declination) * core::cos(place.latitude);
    const double west = core::cos(sun.declination) * core::sin(hour);
    const double up = core::cos(sun.declination) * core::cos(hour) * core::cos(place.latitude) +
                      core::sin(sun.declination) * core::sin(place.latitude);
    return {.azimuth = core::normalized(Angle::fromRad(std::atan2(-west, -south))),
            .zenith_angle = Angle::fromRad(std::atan2(std::hypot(south, west), up))};
}

}  // namespace pmts::targeting
