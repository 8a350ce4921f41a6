#pragma once

#include "pmts/targeting/patch_matcher.hpp"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace pmts::targeting {

/// A smooth map from old to new pixels around a click: a quadratic in the offset from the click, which a turn
/// of the camera and its lens follow to a small part of a pixel over a few hundred. Evaluated fast for whole
/// windows; the same map samples the window and carries the match back, so that it cancels out.
class PictureMap {
public:
    /// Least squares over a grid of offsets up to `reach_px`; absent when the model sees too few of them.
    [[nodiscard]] static std::optional<PictureMap> fitted(const Expectation& expected,
                                                          const Eigen::Vector2d& click_px, double reach_px);
    [[nodiscard]] static PictureMap identityAt(const Eigen::Vector2d& click_px);

    [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& offset_px) const;
    /// The same map with the old picture turned first, about the click.
    [[nodiscard]] PictureMap turned(double angle_rad) const;
    /// The picture at the offsets `step_px` * (x, y) for every (x, y) of `offsets`, bicubic.
    [[nodiscard]] cv::Mat sampled(const cv::Mat& picture, const cv::Rect& offsets, double step_px) const;

private:
    using Coefficients = Eigen::Matrix<double, 2, 6>;
    explicit PictureMap(Coefficients coefficients, Eigen::Matrix2d turn = Eigen::Matrix2d::Identity())
        : coefficients_(std::move(coefficients)), turn_(std::move(turn)) {}

    Coefficients coefficients_;  ///< of 1, x, y, x2, xy, y2
    Eigen::Matrix2d turn_;
};

}  // namespace pmts::targeting
