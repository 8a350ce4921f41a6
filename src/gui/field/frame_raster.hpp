#pragma once

#include "pmts/camera/frame.hpp"

#include <QImage>
#include <QRect>
#include <QSize>

namespace pmts::gui {

/// Turns a part of a frame into pixels of the screen. Scaling is OpenCV's: QPainter scales 24-bit pictures in
/// its slow general path (16 ms for 1280x720), this takes about 1 ms. Keeps its buffers and its last result.
class FrameRaster {
public:
    /// `part` of the frame, whole pixels, scaled to `size` device pixels. Valid until the next call.
    [[nodiscard]] const QImage& render(const camera::FramePtr& frame, const QRect& part, QSize size);

private:
    camera::FramePtr frame_;
    QRect part_;
    QSize size_;
    cv::Mat scaled_, screen_;
    QImage image_;
};

}  // namespace pmts::gui
