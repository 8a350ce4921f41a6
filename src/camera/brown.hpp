#pragma once

#include "pmts/camera/lens.hpp"

#include <optional>

namespace pmts::camera::brown {

/// Smallest x2 + y2 at which r (1 + k1 r2 + k2 r4 + k3 r6) stops growing; infinity when it never does.
[[nodiscard]] double foldR2(const BrownLens& lens);

/// Distorted image coordinates x', y' of x = X/Z, y = Y/Z; nothing past the fold.
[[nodiscard]] std::optional<Eigen::Vector2d> distorted(const BrownLens& lens, double fold_r2,
                                                       const Eigen::Vector2d& xy);

/// Inverse of distorted(), by Newton's method; nothing where there is none.
[[nodiscard]] std::optional<Eigen::Vector2d> undistorted(const BrownLens& lens, double fold_r2,
                                                         const Eigen::Vector2d& distorted_xy);

}  // namespace pmts::camera::brown
