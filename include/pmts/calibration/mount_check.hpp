#pragma once

#include "pmts/camera/rig.hpp"
#include "pmts/core/result.hpp"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace pmts::calibration {

/// A detail of the first picture found again in the second.
struct MovedDetail {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();           ///< in the first picture
    Eigen::Vector2d moved_px = Eigen::Vector2d::Zero();     ///< second less first
    Eigen::Vector2d expected_px = Eigen::Vector2d::Zero();  ///< the same, were the camera on the telescope
};

/// What the picture did while the telescope was tilted.
struct MountCheck {
    std::optional<camera::MountKind> kind;  ///< absent when the details do not agree on one of the two
    double confidence = 0.0;                ///< share of the details that say so, 0 to 1
    double moved_px = 0.0;                  ///< median, along the direction a telescope camera's would take
    double expected_px = 0.0;               ///< median for a camera on the telescope
    std::vector<MovedDetail> details;
};

/// Tells a camera on the telescope (the picture moves by the tilt) from one on the handle (it stays) by two
/// pictures taken before and after a turn of VA. The lens may be a third off. kLimit when the turn moves a
/// telescope's picture by less than 8 px or more than a third of its height, kUndefined when the pictures
/// show too little to follow (sky, plain wall, covered lens). Callable on any thread; 0.1 s at 1280x720.
[[nodiscard]] core::Result<MountCheck> mountFromMotion(const cv::Mat& before, const geometry::Pointing& at_before,
                                                       const cv::Mat& after, const geometry::Pointing& at_after,
                                                       const camera::Rig& rig);

}  // namespace pmts::calibration
