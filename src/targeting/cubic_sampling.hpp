#pragma once

#include <opencv2/core/mat.hpp>

namespace pmts::targeting {

/// Grey values (CV_32F) of a picture (CV_32F) at `places` (CV_32FC2, x then y), bicubic, edges repeated.
/// cv::remap rounds places to 1/32 px, which is a third of what a re-centring promises.
[[nodiscard]] cv::Mat cubicSampled(const cv::Mat& picture, const cv::Mat& places);

}  // namespace pmts::targeting
