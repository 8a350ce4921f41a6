#pragma once

#include "pmts/camera/lens.hpp"

#include <optional>

namespace pmts::camera::fisheye {

/// Angle off the axis at which the radius in the picture stops growing, rad; at most pi.
[[nodiscard]] double foldAngle_rad(const FisheyeLens& lens);

/// Radius in units of f at an angle off the axis; nothing past the fold.
[[nodiscard]] std::optional<double> radiusAtAngle(const FisheyeLens& lens, double fold_rad, double angle_rad);

/// Inverse of radiusAtAngle(), by Newton's method kept inside a bracket.
[[nodiscard]] std::optional<double> angleAtRadius(const FisheyeLens& lens, double fold_rad, double radius);

}  // namespace pmts::camera::fisheye
