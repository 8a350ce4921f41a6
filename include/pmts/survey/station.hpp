#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/geometry/pointing.hpp"

#include <QString>

namespace pmts::survey {

/// A set-up of the instrument in the ground system. N is the cosine of the bearing (protocol page 4.3).
struct Station {
    QString name = QStringLiteral("100");
    double e_m = 1000.0;  ///< the thesis's defaults, 1000/1000/100
    double n_m = 1000.0;
    double h_m = 100.0;
    double instrument_height_m = 0.0;
    core::Angle orientation{};  ///< added to HA it gives the bearing from grid north
};

/// Orientation that makes the circle reading `ha` point along `bearing`.
[[nodiscard]] core::Angle orientationFor(core::Angle ha, core::Angle bearing);

/// Bearing, clockwise from north in [0, 400) gon, from a station to known coordinates.
[[nodiscard]] core::Angle bearingTo(const Station& station, double e_m, double n_m);

}  // namespace pmts::survey
