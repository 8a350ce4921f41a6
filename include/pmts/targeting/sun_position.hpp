#pragma once

#include "pmts/core/angle.hpp"

#include <QDateTime>

namespace pmts::targeting {

/// Where the instrument stands on Earth.
struct Place {
    core::Angle latitude;   ///< north positive
    core::Angle longitude;  ///< east positive

    [[nodiscard]] bool operator==(const Place&) const = default;
};

struct SunPosition {
    core::Angle azimuth;       ///< clockwise from true north, [0, 400) gon
    core::Angle zenith_angle;  ///< of the centre, without refraction
};

/// The Sun seen from a place, by NOAA's short form of Meeus's formulas (Astronomical Algorithms, ch. 25).
/// Error: below 0.02 degrees from 1950 to 2050; refraction, up to 0.6 degrees at the horizon, is not in it.
[[nodiscard]] SunPosition sunPosition(const Place& place, const QDateTime& utc);

}  // namespace pmts::targeting
