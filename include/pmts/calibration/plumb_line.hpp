#pragma once

#include "pmts/camera/rig.hpp"
#include "pmts/core/result.hpp"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace pmts::calibration {

struct PlumbLineSettings {
    double most_lean_gon = 20.0;   ///< from the picture's columns
    double least_length = 0.3;     ///< of the picture's height
    double least_contrast_grey = 10.0;
    double near_px = 40.0;         ///< of the place that was clicked, when one was
};

/// A thin straight thing, lighter or darker than both its sides, as sub-pixel places along its middle.
struct PictureLine {
    std::vector<Eigen::Vector2d> places_px;  ///< from top to bottom, one a row at most
    double length_px = 0.0;
    double contrast_grey = 0.0;
};

/// Finds the plumb line: rows vote for straight lines of the picture freed of the lens's distortion, the
/// places are the grey values' centroids along the winner. kNotReached when nothing long enough is there or
/// (without a click) two lines are equally long; Error::detail is `none` or `several`. Any thread; 40 ms at
/// 1280x720.
[[nodiscard]] core::Result<PictureLine> findPlumbLine(const cv::Mat& bgr, const camera::Lens& lens,
                                                      const std::optional<Eigen::Vector2d>& clicked_px = {},
                                                      const PlumbLineSettings& settings = {});

/// The camera's twist that makes a line vertical.
struct TwistFromLine {
    core::Angle twist;        ///< of Mount: positive is clockwise seen from behind
    core::Angle sigma;        ///< one sigma from the places left over
    double unrest_px = 0.0;   ///< rms of the places from straight: a swinging line or a wrong lens
    int places = 0;           ///< used; the others were thrown out as wrong
};

/// What is vertical and the camera's centre span a vertical plane: every ray to the line lies in it, wherever
/// in the picture and at whatever tilt (station frame of a levelled instrument). Yaw, pitch and mount kind of
/// `rig` are believed; of its twist only the half turn is used. kUndefined with fewer than 10 places, for a
/// line shorter than 40 px, and for a camera that looks along the line.
[[nodiscard]] core::Result<TwistFromLine> twistFromLine(const PictureLine& line, const camera::Rig& rig,
                                                        const geometry::Pointing& at);

}  // namespace pmts::calibration
