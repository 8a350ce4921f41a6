#pragma once

#include "pmts/core/angle.hpp"

namespace pmts::geometry {

/// Where the telescope points: circle readings of the instrument.
struct Pointing {
    core::Angle ha;  ///< clockwise from the circle's zero, any turn
    core::Angle va;  ///< zenith angle: 100 gon is horizontal, above 200 gon is face II

    [[nodiscard]] bool operator==(const Pointing&) const = default;
};

}  // namespace pmts::geometry
