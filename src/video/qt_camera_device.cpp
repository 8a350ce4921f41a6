#include "capture_device.hpp"
#include "picture_format.hpp"

#include <QCamera>
#include <QCameraDevice>
#include <QCoreApplication>
#include <QEventLoop>
#include <QImage>
#include <QMediaCaptureSession>
#include <QMediaDevices>
#include <QTimer>
#include <QVideoFrame>
#include <QVideoSink>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <mutex>

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

/// Maps the frame instead of QVideoFrame::toImage(), which goes through OpenGL and costs twenty times as
/// much.
cv::Mat bgrFromQt(QVideoFrame frame) {
    if (!frame.map(QVideoFrame::ReadOnly)) {
        return {};
    }
    cv::Mat bgr;
    const auto row_bytes = static_cast<std::size_t>(frame.bytesPerLine(0));
    if (const auto layout = layoutOf(frame.pixelFormat())) {
        // NV12's second plane follows the first in every backend; planes elsewhere give an empty picture.
        const bool joined =
            frame.planeCount() < 2 ||
            frame.bits(1) == frame.bits(0) + row_bytes * static_cast<std::size_t>(frame.height());
        const auto bytes = static_cast<std::size_t>(frame.mappedBytes(0)) +
                           (frame.planeCount() > 1 ? static_cast<std::size_t>(frame.mappedBytes(1)) : 0U);
        if (joined) {
            bgr = bgrFrom({*layout, frame.width(), frame.height(), row_bytes, frame.bits(0), bytes});
        }
    } else if (const auto format = QVideoFrameFormat::imageFormatFromPixelFormat(frame.pixelFormat());
               format != QImage::Format_Invalid) {
        const QImage shared(frame.bits(0), frame.width(), frame.height(), frame.bytesPerLine(0), format);
        const QImage rgb = shared.convertToFormat(QImage::Format_BGR888);
        cv::Mat(rgb.height(), rgb.width(), CV_8UC3, const_cast<uchar*>(rgb.constBits()),
                static_cast<std::size_t>(rgb.bytesPerLine()))
            .copyTo(bgr);
    }
    frame.unmap();
    return bgr;
}

/// QCamera lives here on the worker, not on the GUI thread: its start and stop may block for ever.
class QtCameraDevice final : public CaptureDevice {
public:
    explicit QtCameraDevice(QString description) : description_(std::move(description)) {}

    core::Result<void> open(const VideoFormat& wanted) override {
        const QEventLoop gives_this_thread_its_notifiers;  // before any Qt object that needs them
        const QList<QCameraDevice> present = QMediaDevices::videoInputs();
        const auto found = std::find_if(present.begin(), present.end(), [this](const QCameraDevice& device) {
            return device.description() == description_;
        });
        if (found == present.end()) {  // QCamera would start with a test picture instead
            return core::fail(
                core::ErrorKind::kCamera,
                QCoreApplication::translate("QtCamera", "%1 is not connected.").arg(description_),
                QCoreApplication::translate("QtCamera", "Plug it in; the live view starts by itself."));
        }
        parts_ = std::make_unique<Parts>(*found);
        parts_->camera.setCameraFormat(nearest(*found, wanted));
        parts_->session.setCamera(&parts_->camera);
        parts_->session.setVideoSink(&parts_->sink);
        QObject::connect(
            &parts_->sink, &QVideoSink::videoFrameChanged, &parts_->sink,
            [this](const QVideoFrame& frame) { receive(frame); }, Qt::DirectConnection);
        parts_->camera.start();
        return {};
    }

    core::Result<std::optional<Shot>> next(core::Duration limit) override {
        if (!hasFrame()) {
            turnLoop(limit);
        }
        const std::lock_guard lock(mutex_);
        if (!arrived_) {
            return std::nullopt;
        }
        held_ = std::move(arrived_->frame);
        const Shot shot = arrived_->shot;
        arrived_.reset();
        return shot;
    }

    camera::Frame picture() override {
        camera::Frame frame;
        frame.image = bgrFromQt(std::exchange(held_, QVideoFrame()));
        return frame;
    }

    void close() override {
        parts_.reset();
        const std::lock_guard lock(mutex_);
        arrived_.reset();
    }

    void interrupt() override {
        const std::lock_guard lock(mutex_);
        if (loop_ != nullptr) {
            QMetaObject::invokeMethod(loop_, &QEventLoop::quit, Qt::QueuedConnection);
        }
    }

private:
    struct Parts {
        explicit Parts(const QCameraDevice& device) : camera(device) {}
        QCamera camera;
        QVideoSink sink;
        QMediaCaptureSession session;
    };
    struct Arrival {
        QVideoFrame frame;
        Shot shot;
    };

    static QCameraFormat nearest(const QCameraDevice& device, const VideoFormat& wanted) {
        const QList<QCameraFormat> formats = device.videoFormats();
        const auto off = [&](const QCameraFormat& format) {
            const QSize difference = format.resolution() - wanted.size;
            return (std::abs(difference.width()) + std::abs(difference.height())) * 1000.0 +
                   std::max(0.0, wanted.rate_hz - static_cast<double>(format.maxFrameRate()));
        };
        const auto best =
            std::min_element(formats.begin(), formats.end(),
                             [&](const QCameraFormat& a, const QCameraFormat& b) { return off(a) < off(b); });
        return best == formats.end() ? QCameraFormat() : *best;
    }

    /// Called on the backend's thread; only the newest frame is kept.
    void receive(const QVideoFrame& frame) {
        if (!frame.isValid()) {
            return;
        }
        const std::lock_guard lock(mutex_);
        arrived_ = Arrival{frame, {sequence_++, now()}};
        if (loop_ != nullptr) {
            QMetaObject::invokeMethod(loop_, &QEventLoop::quit, Qt::QueuedConnection);
        }
    }

    [[nodiscard]] bool hasFrame() {
        const std::lock_guard lock(mutex_);
        return arrived_.has_value();
    }

    /// This thread's event loop, in slices: the backend's notifiers live on it.
    void turnLoop(core::Duration limit) {
        QEventLoop loop;
        QTimer::singleShot(std::chrono::duration_cast<std::chrono::milliseconds>(limit), &loop,
                           &QEventLoop::quit);
        setLoop(&loop);
        loop.exec();
        setLoop(nullptr);
    }
    void setLoop(QEventLoop* loop) {
        const std::lock_guard lock(mutex_);
        loop_ = loop;
        if (loop != nullptr && arrived_) {
            QMetaObject::invokeMethod(loop, &QEventLoop::quit, Qt::QueuedConnection);
        }
    }

    QString description_;
    std::unique_ptr<Parts> parts_;
    QVideoFrame held_;
    std::mutex mutex_;
    QEventLoop* loop_ = nullptr;
    std::optional<Arrival> arrived_;
    std::uint64_t sequence_ = 0;
};

}  // namespace

std::unique_ptr<CaptureDevice> makeQtCameraDevice(const QString& description) {
    return std::make_unique<QtCameraDevice>(description);
}

}  // namespace pmts::video
