#pragma once

#include "pmts/camera/lens.hpp"

#include <optional>

/// OpenCV's rational model; Brown's is the same with a denominator of one.
namespace pmts::camera::rational {

[[nodiscard]] RationalLens asRational(const BrownLens& lens);

/// Smallest x2 + y2 at which the radius in the picture stops growing, or the denominator's first zero;
/// infinity when there is neither.
[[nodiscard]] double foldR2(const RationalLens& lens);

/// Distorted image coordinates x', y' of x = X/Z, y = Y/Z; nothing past the fold.
[[nodiscard]] std::optional<Eigen::Vector2d> distorted(const RationalLens& lens, double fold_r2,
                                                       const Eigen::Vector2d& xy);

/// Inverse of distorted(), by Newton's method; nothing where there is none.
[[nodiscard]] std::optional<Eigen::Vector2d> undistorted(const RationalLens& lens, double fold_r2,
                                                         const Eigen::Vector2d& distorted_xy);

}  // namespace pmts::camera::rational
