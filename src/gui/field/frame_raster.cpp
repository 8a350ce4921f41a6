#include "frame_raster.hpp"

#include <opencv2/imgproc.hpp>

namespace pmts::gui {
namespace {

constexpr double kShowPixelsFrom =
    3.0;  ///< device pixels per image pixel above which pixels are shown as squares
constexpr double kAverageBelow = 0.5;  ///< shrinking more than this aliases without averaging

int interpolationFor(QSize part, QSize size) {
    const double scale = static_cast<double>(size.width()) / part.width();
    if (scale >= kShowPixelsFrom) {
        return cv::INTER_NEAREST;
    }
    return scale < kAverageBelow ? cv::INTER_AREA : cv::INTER_LINEAR;
}

}  // namespace

const QImage& FrameRaster::render(const camera::FramePtr& frame, const QRect& part, QSize size) {
    if (frame == frame_ && part == part_ && size == size_) {
        return image_;
    }
    frame_ = frame;
    part_ = part;
    size_ = size;
    const cv::Mat source = frame->image(cv::Rect(part.x(), part.y(), part.width(), part.height()));
    if (part.size() == size) {
        cv::cvtColor(source, screen_, cv::COLOR_BGR2BGRA);
    } else {
        cv::resize(source, scaled_, cv::Size(size.width(), size.height()), 0, 0,
                   interpolationFor(part.size(), size));
        cv::cvtColor(scaled_, screen_, cv::COLOR_BGR2BGRA);
    }
    image_ = QImage(screen_.data, screen_.cols, screen_.rows, static_cast<qsizetype>(screen_.step),
                    QImage::Format_RGB32);
    return image_;
}

}  // namespace pmts::gui
