#pragma once

#include "pmts/targeting/snap.hpp"

namespace pmts::targeting {

/// Circles and ellipses in a grey (CV_8U) window, pixels of the window.
[[nodiscard]] std::vector<SnapCandidate> roundMarks(const cv::Mat& grey, const SnapSettings& settings);

/// How far a pixel is from the outline of a round mark, about.
[[nodiscard]] double distanceToOutline_px(const SnapCandidate& mark, const Eigen::Vector2d& px);

}  // namespace pmts::targeting
