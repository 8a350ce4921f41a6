#pragma once

#include <opencv2/core/mat.hpp>

#include <array>
#include <optional>

namespace pmts::camera {

/// Share of the measured pixels at each of the 256 levels; the sum is 1.
using Histogram = std::array<float, 256>;

/// What a look at one picture says about exposure and focus.
struct PictureMeters {
    Histogram luma{}, red{}, green{}, blue{};
    double burnt_share = 0.0;  ///< pixels with a channel at 254 or above: 0 to 1
    double black_share = 0.0;  ///< pixels with every channel at 1 or below
    double mean_luma = 0.0;    ///< 0 to 255
    double sharpness = 0.0;
    std::optional<double> box_sharpness;  ///< of the box alone
};

/// Levels at which a pixel counts as burnt out or black: a sensor's ends, noise allowed for.
inline constexpr int kBurntLevel = 254;
inline constexpr int kBlackLevel = 1;

/// Histograms and shares from every second pixel each way, sharpness from all. BGR, 8 bit; about 5 ms at 1280x720.
/// Sharpness is Tenengrad: the mean squared Sobel gradient of the grey picture over its variance, times 100. The division
/// takes contrast and exposure out; noise remains, so compare pictures of one scene only (Pertuz et al. 2013, GRA6).
/// An empty picture gives zeros; a box outside the picture is left out.
[[nodiscard]] PictureMeters measurePicture(const cv::Mat& bgr, const std::optional<cv::Rect>& box = std::nullopt);

/// 255 where a channel has reached kBurntLevel, else 0.
[[nodiscard]] cv::Mat burntMask(const cv::Mat& bgr);

}  // namespace pmts::camera
