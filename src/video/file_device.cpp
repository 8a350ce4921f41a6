#include "capture_device.hpp"
#include "tick_pacer.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <opencv2/videoio.hpp>

namespace pmts::video {
namespace {

/// A video file played at its own pace, over and over.
class FileDevice final : public CaptureDevice {
public:
    explicit FileDevice(QString path) : path_(std::move(path)) {}

    core::Result<void> open(const VideoFormat&) override {
        if (!QFileInfo(path_).isReadable() || !file_.open(path_.toStdString(), cv::CAP_FFMPEG)) {
            return trouble(QCoreApplication::translate("VideoFile", "The video file %1 cannot be played."));
        }
        const double rate_hz = file_.get(cv::CAP_PROP_FPS);
        pacer_.start(rate_hz > 0.5 && rate_hz <= 240.0 ? rate_hz : 25.0);
        return {};
    }
    core::Result<std::optional<Shot>> next(core::Duration limit) override {
        const auto tick = pacer_.wait(limit);
        if (!tick) {
            return std::nullopt;
        }
        if (!file_.grab() && !rewindAndGrab()) {
            return trouble(QCoreApplication::translate(
                "VideoFile", "The video file %1 ended and cannot be played again."));
        }
        return Shot{tick->number, tick->due};
    }
    camera::Frame picture() override {
        camera::Frame frame;
        cv::Mat decoded;
        if (file_.retrieve(decoded)) {
            frame.image = decoded.clone();  // the decoder keeps its buffer
        }
        return frame;
    }
    void close() override { file_.release(); }
    DeviceReport report() override {
        const VideoFormat only{QSize(static_cast<int>(file_.get(cv::CAP_PROP_FRAME_WIDTH)),
                                     static_cast<int>(file_.get(cv::CAP_PROP_FRAME_HEIGHT))),
                               file_.get(cv::CAP_PROP_FPS), QString()};
        return {only, {only}, {}};
    }
    void interrupt() override { pacer_.interrupt(); }

private:
    [[nodiscard]] bool rewindAndGrab() {
        return file_.open(path_.toStdString(), cv::CAP_FFMPEG) && file_.grab();
    }

    [[nodiscard]] tl::unexpected<core::Error> trouble(const QString& happened) const {
        return core::fail(core::ErrorKind::kCamera, happened.arg(QFileInfo(path_).fileName()),
                          QCoreApplication::translate("VideoFile", "Choose another file, or a camera."),
                          path_);
    }

    QString path_;
    cv::VideoCapture file_;
    TickPacer pacer_;
};

}  // namespace

std::unique_ptr<CaptureDevice> makeFileDevice(const QString& path) {
    return std::make_unique<FileDevice>(path);
}

}  // namespace pmts::video
