#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace pmts::targeting {

/// Offsets of a patch from the click: `window` pixel = turn * (patch pixel - click_in_patch) + at.
struct PatchWarp {
    Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< where the click is in the window
};

struct ShiftFit {
    PatchWarp warp;
    double score = 0.0;     ///< weighted correlation coefficient
    double sigma_px = 0.0;  ///< of warp.at, weaker direction
    /// How far the left, right, upper or lower part of the patch still wants to go by itself, beyond three
    /// sigma: the patch does not move as one surface.
    double unrest_px = 0.0;
    double kept = 1.0;  ///< share of the weights that outliers left: the rest is another surface
    double deformation =
        0.0;  ///< largest part of the warp that is no shift: an edge in depth shears the patch
};

/// Weight of each patch pixel: a bell around the click, because the click's own surface is what counts and
/// what is farther off may stand at another depth.
[[nodiscard]] cv::Mat bellWeights(cv::Size size, const cv::Point2d& click, double half_px);

/// One sigma of a shift in its weaker direction between two pictures of a camera with this noise.
[[nodiscard]] double expectedSigma_px(const cv::Mat& patch, const cv::Point2d& click, const cv::Mat& weights,
                                      double noise_grey);

/// Weighted least squares of an affine warp with gain and offset of the grey values, from a start that is
/// within about a pixel. Outliers lose their weight (Tukey). Absent when it does not settle.
[[nodiscard]] std::optional<ShiftFit> fitShift(const cv::Mat& patch, const cv::Point2d& click,
                                               const cv::Mat& weights, const cv::Mat& window,
                                               const PatchWarp& start);

}  // namespace pmts::targeting
