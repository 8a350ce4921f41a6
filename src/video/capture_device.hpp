#pragma once

#include "pmts/camera/frame.hpp"
#include "pmts/core/result.hpp"
#include "pmts/video/video_source.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace pmts::video {

/// A picture the device has taken; its pixels are fetched only when somebody wants them.
struct Shot {
    std::uint64_t sequence = 0;  ///< of the device: a gap is a lost frame
    core::Duration captured_at{0};
};

/// A camera as its worker sees it. Everything but interrupt() is called on the worker, one call at a time.
class CaptureDevice {
public:
    virtual ~CaptureDevice() = default;

    /// Opens and starts it. Fails with kCamera: missing, busy, no permission, no usable format.
    [[nodiscard]] virtual core::Result<void> open(const VideoFormat& wanted) = 0;
    /// The next picture, waiting at most `limit`; nullopt when none came. An error means the device is gone.
    [[nodiscard]] virtual core::Result<std::optional<Shot>> next(core::Duration limit) = 0;
    /// Pixels of the shot next() returned last; the image is empty when they are damaged.
    [[nodiscard]] virtual camera::Frame picture() = 0;
    virtual void close() = 0;
    /// Of the opened device: the mode it runs in, those it offers, its controls as they stand now.
    [[nodiscard]] virtual DeviceReport report() { return {}; }
    /// Opened device only. A control it does not have is not an error.
    virtual void setControl(const ControlValue& wish) { (void)wish; }
    /// Ends a waiting next() early, from any thread, where the device allows it.
    virtual void interrupt() {}
};

using DeviceFactory = std::function<std::unique_ptr<CaptureDevice>()>;

[[nodiscard]] std::unique_ptr<CaptureDevice> makeSimulatedDevice(FramePainter painter);
[[nodiscard]] std::unique_ptr<CaptureDevice> makeSimulatedDevice(ExposurePainter painter);
[[nodiscard]] std::unique_ptr<CaptureDevice> makeFileDevice(const QString& path);
[[nodiscard]] std::unique_ptr<CaptureDevice> makeStreamDevice(const QString& url);
[[nodiscard]] std::unique_ptr<CaptureDevice> makeV4l2Capture(const SourceAddress& address);
[[nodiscard]] std::unique_ptr<CaptureDevice> makeQtCameraDevice(const QString& description);

/// Monotonic time on the scale of core::Clock.
[[nodiscard]] core::Duration now();

}  // namespace pmts::video
