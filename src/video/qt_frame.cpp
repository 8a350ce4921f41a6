#include "qt_frame.hpp"

#include "picture_format.hpp"

#include <QImage>

#include <optional>

namespace pmts::video {
namespace {

std::optional<PixelLayout> layoutOf(QVideoFrameFormat::PixelFormat format) {
    switch (format) {
        case QVideoFrameFormat::Format_YUYV:
            return PixelLayout::kYuyv;
        case QVideoFrameFormat::Format_NV12:
            return PixelLayout::kNv12;
        case QVideoFrameFormat::Format_Jpeg:
            return PixelLayout::kMjpg;
        default:
            return std::nullopt;
    }
}

cv::Mat fromLayout(const QVideoFrame& frame, PixelLayout layout) {
    const auto row_bytes = static_cast<std::size_t>(frame.bytesPerLine(0));
    // NV12's second plane follows the first in every backend; planes elsewhere give an empty picture.
    const bool joined = frame.planeCount() < 2 ||
                        frame.bits(1) == frame.bits(0) + row_bytes * static_cast<std::size_t>(frame.height());
    const auto bytes = static_cast<std::size_t>(frame.mappedBytes(0)) +
                       (frame.planeCount() > 1 ? static_cast<std::size_t>(frame.mappedBytes(1)) : 0U);
    return joined ? bgrFrom({layout, frame.width(), frame.height(), row_bytes, frame.bits(0), bytes})
                  : cv::Mat();
}

cv::Mat fromImage(const QVideoFrame& frame, QImage::Format format) {
    const QImage shared(frame.bits(0), frame.width(), frame.height(), frame.bytesPerLine(0), format);
    const QImage bgr = shared.convertToFormat(QImage::Format_BGR888);
    return cv::Mat(bgr.height(), bgr.width(), CV_8UC3, const_cast<uchar*>(bgr.constBits()),
                   static_cast<std::size_t>(bgr.bytesPerLine()))
        .clone();
}

}  // namespace

QString formatName(QVideoFrameFormat::PixelFormat format) {
    switch (format) {
        case QVideoFrameFormat::Format_YUYV: return QStringLiteral("YUYV");
        case QVideoFrameFormat::Format_NV12: return QStringLiteral("NV12");
        case QVideoFrameFormat::Format_Jpeg: return QStringLiteral("MJPG");
        default: return QVideoFrameFormat::pixelFormatToString(format).remove(QStringLiteral("Format_"));
    }
}

bool isReadable(QVideoFrameFormat::PixelFormat format) {
    return layoutOf(format) ||
           QVideoFrameFormat::imageFormatFromPixelFormat(format) != QImage::Format_Invalid;
}

/// Maps the frame instead of QVideoFrame::toImage(), which goes through OpenGL and costs twenty times as
/// much.
cv::Mat bgrFromQt(QVideoFrame frame) {
    if (!isReadable(frame.pixelFormat()) || !frame.map(QVideoFrame::ReadOnly)) {
        return {};
    }
    const auto layout = layoutOf(frame.pixelFormat());
    const cv::Mat bgr =
        layout ? fromLayout(frame, *layout)
               : fromImage(frame, QVideoFrameFormat::imageFormatFromPixelFormat(frame.pixelFormat()));
    frame.unmap();
    return bgr;
}

}  // namespace pmts::video
