#include "capture_device.hpp"

#include <QCoreApplication>
#include <QUrl>
#include <opencv2/videoio.hpp>

namespace pmts::video {
namespace {

constexpr int kOpenLimit_ms = 5000;
constexpr int kReadLimit_ms = 3000;

/// A network camera (RTSP, MJPEG over HTTP). FFmpeg reads as fast as frames arrive; a read blocks for
/// kReadLimit_ms at most.
class StreamDevice final : public CaptureDevice {
public:
    explicit StreamDevice(QString url) : url_(std::move(url)) {}

    core::Result<void> open(const VideoFormat&) override {
        const std::vector<int> limits{cv::CAP_PROP_OPEN_TIMEOUT_MSEC, kOpenLimit_ms,
                                      cv::CAP_PROP_READ_TIMEOUT_MSEC, kReadLimit_ms};
        if (!stream_.open(url_.toStdString(), cv::CAP_FFMPEG, limits)) {
            return trouble(
                QCoreApplication::translate("VideoStream", "The network camera %1 does not answer."));
        }
        sequence_ = 0;
        return {};
    }
    core::Result<std::optional<Shot>> next(core::Duration) override {
        if (!stream_.grab()) {
            return trouble(
                QCoreApplication::translate("VideoStream", "The network camera %1 has stopped sending."));
        }
        return Shot{sequence_++, now()};
    }
    camera::Frame picture() override {
        camera::Frame frame;
        cv::Mat decoded;
        if (stream_.retrieve(decoded)) {
            frame.image = decoded.clone();
        }
        return frame;
    }
    void close() override { stream_.release(); }
    DeviceReport report() override {
        const VideoFormat only{QSize(static_cast<int>(stream_.get(cv::CAP_PROP_FRAME_WIDTH)),
                                     static_cast<int>(stream_.get(cv::CAP_PROP_FRAME_HEIGHT))),
                               stream_.get(cv::CAP_PROP_FPS), QString()};
        return {only, {only}, {}};
    }

private:
    [[nodiscard]] tl::unexpected<core::Error> trouble(const QString& happened) const {
        const QString shown = QUrl(url_).toString(QUrl::RemoveUserInfo | QUrl::RemoveQuery);
        return core::fail(
            core::ErrorKind::kCamera, happened.arg(shown),
            QCoreApplication::translate(
                "VideoStream", "Check the network and the camera's power; the live view returns by itself."),
            shown);
    }

    QString url_;
    cv::VideoCapture stream_;
    std::uint64_t sequence_ = 0;
};

}  // namespace

std::unique_ptr<CaptureDevice> makeStreamDevice(const QString& url) {
    return std::make_unique<StreamDevice>(url);
}

}  // namespace pmts::video
