#pragma once

#include <opencv2/core/mat.hpp>

namespace pmts::camera {

/// How a picture is changed for the eye (thesis 4.6: smooth, sharp, edgeD, RGB). Strengths from 0 (nothing) to 1.
struct ImageFilter {
    double smooth = 0.0;  ///< balance of contrast: local histogram, colours kept
    double sharp = 0.0;   ///< unsharp mask
    double edges = 0.0;   ///< from the picture to its edges alone, dark on white
    bool single_band = false;                       ///< shows `band` as grey
    int band = 0;                                   ///< 0 red, 1 green, 2 blue
    double red = 1.0, green = 1.0, blue = 1.0;      ///< gains, 0 to 4; 0 takes the band out

    [[nodiscard]] bool operator==(const ImageFilter&) const = default;
    [[nodiscard]] bool isNone() const { return *this == ImageFilter{}; }
};

/// Contrast balance: CLAHE on the lightness, brought back to the mean lightness it had. 8-bit BGR in and out.
[[nodiscard]] cv::Mat smoothed(const cv::Mat& bgr, double strength);
/// Unsharp mask of 1.5 px: plain areas stay, edges get steeper.
[[nodiscard]] cv::Mat sharpened(const cv::Mat& bgr, double strength);
/// Gradient magnitude (Sobel after a light blur) as dark lines on white, mixed over the picture by strength.
[[nodiscard]] cv::Mat edgesOf(const cv::Mat& bgr, double strength);
/// Gains of the bands, or one band alone as grey.
[[nodiscard]] cv::Mat bandsOf(const cv::Mat& bgr, const ImageFilter& filter);

/// All of them, in the order bands, smooth, sharp, edges. The picture given is never written to; without a filter it is
/// handed back as it is. Pixels stay where they are: a click in the filtered picture is one in the original.
[[nodiscard]] cv::Mat filtered(const cv::Mat& bgr, const ImageFilter& filter);

}  // namespace pmts::camera
