#include "qt_camera_backend.hpp"

#include "qt_camera_controls.hpp"
#include "qt_frame.hpp"

#include <QCamera>
#include <QCameraDevice>
#include <QEventLoop>
#include <QMediaCaptureSession>
#include <QMediaDevices>
#include <QVideoSink>

#include <algorithm>
#include <cstdlib>

namespace pmts::video {
namespace {

constexpr double kUnreadable = 1e9;

std::optional<QCameraDevice> findCamera(const QString& description) {
    const QList<QCameraDevice> present = QMediaDevices::videoInputs();
    const auto found = std::ranges::find(present, description, &QCameraDevice::description);
    return found == present.end() ? std::nullopt : std::optional(*found);
}

VideoFormat readable(const QCameraFormat& format) {
    return {format.resolution(), static_cast<double>(format.maxFrameRate()), formatName(format.pixelFormat())};
}

QCameraFormat nearest(const QCameraDevice& device, const VideoFormat& wanted) {
    const QList<QCameraFormat> formats = device.videoFormats();
    QList<QCameraFormat> chosen;
    std::vector<OfferedFormat> offered;
    for (const QCameraFormat& format : formats) {
        if (wanted.pixel_format.isEmpty() || formatName(format.pixelFormat()) == wanted.pixel_format) {
            chosen.append(format);
            offered.push_back({format.resolution(), static_cast<double>(format.maxFrameRate()), format.pixelFormat()});
        }
    }
    const auto index = nearestFormat(offered, wanted);
    if (index) {
        return chosen.at(static_cast<qsizetype>(*index));
    }
    const bool has_wish = !wanted.pixel_format.isEmpty();
    return has_wish ? nearest(device, {wanted.size, wanted.rate_hz, {}}) : QCameraFormat();
}

class MultimediaBackend final : public QtCameraBackend {
public:
    bool isPresent(const QString& description) override {
        const QEventLoop gives_this_thread_its_notifiers;  // before any Qt object that needs them
        return findCamera(description).has_value();
    }

    void start(const QString& description, const VideoFormat& wanted, Listener listener) override {
        const auto device = findCamera(description);
        if (!device) {  // QCamera would start with a test picture instead
            return listener.error({});
        }
        parts_ = std::make_unique<Parts>(*device);
        parts_->camera.setCameraFormat(nearest(*device, wanted));
        parts_->session.setCamera(&parts_->camera);
        parts_->session.setVideoSink(&parts_->sink);
        QObject::connect(&parts_->sink, &QVideoSink::videoFrameChanged, &parts_->sink, listener.frame,
                         Qt::DirectConnection);
        QObject::connect(
            &parts_->camera, &QCamera::errorOccurred, &parts_->camera,
            [tell = listener.error](QCamera::Error, const QString& text) { tell(text); }, Qt::DirectConnection);
        parts_->camera.start();
    }

    void stop() override { parts_.reset(); }

    DeviceReport report() override {
        if (!parts_) {
            return {};
        }
        DeviceReport report;
        report.format = readable(parts_->camera.cameraFormat());
        for (const QCameraFormat& format : parts_->camera.cameraDevice().videoFormats()) {
            if (isReadable(format.pixelFormat())) {
                report.formats.push_back(readable(format));
            }
        }
        report.controls = qtControls(parts_->camera);
        return report;
    }

    void setControl(const ControlValue& wish) override {
        if (parts_) {
            setQtControl(parts_->camera, wish);
        }
    }

private:
    struct Parts {
        explicit Parts(const QCameraDevice& device) : camera(device) {}
        QCamera camera;
        QVideoSink sink;
        QMediaCaptureSession session;
    };

    std::unique_ptr<Parts> parts_;
};

}  // namespace

std::optional<std::size_t> nearestFormat(const std::vector<OfferedFormat>& offered, const VideoFormat& wanted) {
    const auto off = [&](const OfferedFormat& format) {
        const QSize difference = format.size - wanted.size;
        return (isReadable(format.pixels) ? 0.0 : kUnreadable) +
               (std::abs(difference.width()) + std::abs(difference.height())) * 1000.0 +
               std::max(0.0, wanted.rate_hz * 0.99 - format.rate_hz) +
               std::max(0.0, format.rate_hz - wanted.rate_hz * 1.01) * 0.001;
    };
    const auto best = std::ranges::min_element(offered, {}, off);
    return best == offered.end() ? std::nullopt
                                 : std::optional(static_cast<std::size_t>(best - offered.begin()));
}

std::unique_ptr<QtCameraBackend> makeQtCameraBackend() { return std::make_unique<MultimediaBackend>(); }

}  // namespace pmts::video
