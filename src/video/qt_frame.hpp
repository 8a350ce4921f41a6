#pragma once

#include <QVideoFrame>
#include <opencv2/core/mat.hpp>

namespace pmts::video {

/// Whether bgrFromQt() can read pictures of this pixel format.
[[nodiscard]] bool isReadable(QVideoFrameFormat::PixelFormat format);
/// As in VideoFormat: V4L2's name where there is one, Qt's else.
[[nodiscard]] QString formatName(QVideoFrameFormat::PixelFormat format);
/// An own BGR copy of a frame of Qt Multimedia; empty when it cannot be mapped or read.
[[nodiscard]] cv::Mat bgrFromQt(QVideoFrame frame);

}  // namespace pmts::video
