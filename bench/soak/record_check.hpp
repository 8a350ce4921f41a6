#pragma once

#include "pmts/simulator/scene.hpp"
#include "pmts/survey/point.hpp"
#include "pmts/survey/station.hpp"

#include <QString>

namespace pmts::soak {

/// What a record has to agree with.
struct Truth {
    geometry::Pointing pointing;
    std::optional<double> distance_m;
};

/// A point against the simulator's truth, and E, N, H by the plain polar formula (N = cos). Empty when it is right, else by
/// how much it is off.
[[nodiscard]] QString wrongIn(const survey::Point& point, const Truth& truth, const survey::Station& station);

/// A point of a block that nobody asked for, against the block as it came: HA, VA and SD are those of labels 7, 8 and 9 to
/// the last digit, without a distance it is absurd. Empty when it is so.
[[nodiscard]] QString wrongOfBlock(const survey::Point& point);

}  // namespace pmts::soak
