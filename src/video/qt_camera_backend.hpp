#pragma once

#include "pmts/video/video_source.hpp"

#include <QString>
#include <QVideoFrame>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace pmts::video {

/// A camera of Qt Multimedia as its device needs it; a test puts a camera of its own behind it.
class QtCameraBackend {
public:
    struct Listener {
        std::function<void(const QVideoFrame&)> frame;
        std::function<void(const QString&)> error;  ///< in Qt's words; the camera gives nothing more
    };

    virtual ~QtCameraBackend() = default;
    [[nodiscard]] virtual bool isPresent(const QString& description) = 0;
    /// The listener may be called on any thread until stop() returns.
    virtual void start(const QString& description, const VideoFormat& wanted, Listener listener) = 0;
    virtual void stop() = 0;
    /// Of the started camera; on the thread that started it.
    [[nodiscard]] virtual DeviceReport report() { return {}; }
    virtual void setControl(const ControlValue& wish) { (void)wish; }
};

/// One of the formats a camera offers.
struct OfferedFormat {
    QSize size;
    double rate_hz = 0.0;  ///< at most
    QVideoFrameFormat::PixelFormat pixels = QVideoFrameFormat::Format_Invalid;
};

/// Index of the format nearest to the wanted one: readable pixels first, then size, then rate.
[[nodiscard]] std::optional<std::size_t> nearestFormat(const std::vector<OfferedFormat>& offered,
                                                       const VideoFormat& wanted);

[[nodiscard]] std::unique_ptr<QtCameraBackend> makeQtCameraBackend();

}  // namespace pmts::video
