#pragma once

#include "pmts/camera/lens.hpp"

#include <QByteArray>
#include <QString>

namespace pmts::camera {

/// A lens as other programs exchange it.
struct LensFile {
    Lens lens;
    int width_px = 0;   ///< 0: the file does not say
    int height_px = 0;
    QString note;       ///< what could not be taken over exactly; empty when everything could
};

/// OpenCV's YAML (and ROS's): camera_matrix or K, distortion_coefficients or D with 0, 4, 5 or 8 numbers, or 12 and more whose rest
/// is zero; `distortion_model` fisheye or equidistant, or `fisheye_model: 1`, means four numbers of cv::fisheye.
/// Pixel centres are whole numbers there as here. Our models have one focal length: where fx and fy differ, their mean is
/// taken and the note says what that costs at the edge; above 1 % it is refused.
[[nodiscard]] core::Result<LensFile> lensFromOpenCvYaml(const QByteArray& yaml);
/// kBadInput for a lens that has no place in the format (a distortion table, a residual table).
[[nodiscard]] core::Result<QByteArray> lensToOpenCvYaml(const Lens& lens, int width_px, int height_px);

/// First camera of COLMAP's cameras.txt: SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV, FULL_OPENCV, OPENCV_FISHEYE.
/// COLMAP's (0, 0) is the corner of the first pixel, ours its centre: principal points differ by 0.5 px.
[[nodiscard]] core::Result<LensFile> lensFromColmap(const QByteArray& text);
[[nodiscard]] core::Result<QByteArray> lensToColmap(const Lens& lens, int width_px, int height_px);

/// By its content: COLMAP's text or YAML.
[[nodiscard]] core::Result<LensFile> lensFromFile(const QString& path);
/// By its name: `.txt` is COLMAP, everything else YAML.
[[nodiscard]] core::Result<void> lensToFile(const Lens& lens, int width_px, int height_px, const QString& path);

}  // namespace pmts::camera
