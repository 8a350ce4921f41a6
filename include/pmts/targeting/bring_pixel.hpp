#pragma once

#include "pmts/targeting/pixel_to_pointing.hpp"

namespace pmts::targeting {

/// Circle readings, in the face of `at`, at which what pixel `grabbed` shows at `at` appears at pixel
/// `released`: what a drag asks for. The spot is `slope_distance_m` away; the view is rotated until it fits
/// within 0.001 px. kUndefined when no rotation brings it there (near the plumb line, out of the lens).
[[nodiscard]] core::Result<geometry::Pointing> pointingToBring(const PixelToPointing& model,
                                                               const Eigen::Vector2d& grabbed_px,
                                                               const Eigen::Vector2d& released_px,
                                                               const geometry::Pointing& at,
                                                               double slope_distance_m);

}  // namespace pmts::targeting
