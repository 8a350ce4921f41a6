#pragma once

#include <opencv2/core/mat.hpp>

namespace pmts::camera {

/// A picture brought into another mode of its camera, as scaledRig() brings the rig there. Whole pixels are cut: half a pixel of
/// the larger picture may be left at an edge.
[[nodiscard]] cv::Mat scaledPicture(const cv::Mat& picture, int width_px, int height_px);

}  // namespace pmts::camera
