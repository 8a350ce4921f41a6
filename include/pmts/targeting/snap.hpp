#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace pmts::targeting {

enum class SnapKind {
    kCorner,    ///< of one surface: a window, a brick, a roof
    kCrossing,  ///< of lines, of quadrants, of a chessboard
    kCircle,    ///< centre of a round mark seen straight on
    kEllipse,   ///< centre of a round mark seen askew: the ellipse's centre, not corrected for perspective
};

/// A spot a click may jump to; drawn before the click is made.
struct SnapCandidate {
    SnapKind kind = SnapKind::kCorner;
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    double confidence = 0.0;                                 ///< 0 to 1
    Eigen::Vector2d half_axes_px = Eigen::Vector2d::Zero();  ///< of a circle or ellipse, the longer first
    double axis_angle_rad = 0.0;  ///< of the longer axis, clockwise from right, within a quarter turn
};

struct SnapSettings {
    double radius_px = 15.0;  ///< candidates farther from the cursor do not count
    double least_confidence = 0.5;
    double largest_half_axis_px = 60.0;
    double least_contrast_grey = 12.0;
};

/// All candidates within the radius, the one the click would take first: the nearest, where a crossing and being inside
/// a round mark count as half their distance. Looks at a window around the cursor only.
[[nodiscard]] std::vector<SnapCandidate> snapCandidates(const cv::Mat& bgr, const Eigen::Vector2d& cursor_px,
                                                        const SnapSettings& settings = {});

/// The spot the click takes; absent when nothing is near: the click then stays where it was made.
[[nodiscard]] std::optional<SnapCandidate> snapped(const cv::Mat& bgr, const Eigen::Vector2d& cursor_px,
                                                   const SnapSettings& settings = {});

}  // namespace pmts::targeting
