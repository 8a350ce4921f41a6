#include "pmts/app/desk/frame_image.hpp"

#include <QBuffer>
#include <QByteArray>

#include <memory>

namespace pmts::app {

QImage imageOfFrame(camera::FramePtr frame) {
    if (!frame || frame->image.empty() || frame->image.type() != CV_8UC3) {
        return {};
    }
    const cv::Mat& pixels = frame->image;
    auto keeper = std::make_unique<camera::FramePtr>(frame);
    QImage image(pixels.data, pixels.cols, pixels.rows, static_cast<qsizetype>(pixels.step), QImage::Format_BGR888,
                 [](void* kept) { delete static_cast<camera::FramePtr*>(kept); }, keeper.get());
    if (!image.isNull()) {
        keeper.release();  // the image's clean-up deletes it
    }
    return image;
}

camera::FramePtr frameOfImage(const QImage& image) {
    if (image.isNull()) {
        return nullptr;
    }
    QImage bgr = image.convertToFormat(QImage::Format_BGR888);
    auto frame = std::make_shared<camera::Frame>();
    frame->image = cv::Mat(bgr.height(), bgr.width(), CV_8UC3, bgr.bits(), static_cast<std::size_t>(bgr.bytesPerLine())).clone();
    return frame;
}

QByteArray encodedImage(const QImage& image, const char* format) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    return image.save(&buffer, format) ? bytes : QByteArray();
}

}  // namespace pmts::app
