#pragma once

#include "pmts/camera/frame.hpp"
#include "pmts/core/result.hpp"
#include "pmts/core/video_gate.hpp"
#include "pmts/video/camera_control.hpp"

#include <QObject>
#include <QSize>
#include <QString>

#include <functional>
#include <memory>
#include <vector>

namespace pmts::video {

struct VideoFormat {
    QSize size{1280, 720};
    double rate_hz = 30.0;
    QString pixel_format{};  ///< YUYV, MJPG, NV12, BGR; empty: the source's choice

    [[nodiscard]] bool operator==(const VideoFormat&) const = default;
};

enum class SourceKind { kSimulated, kV4l2, kQtCamera, kFile, kStream };

/// What a person picks in the camera list; enough to open it again after a restart or a replug.
struct SourceAddress {
    SourceKind kind = SourceKind::kSimulated;
    QString location;  ///< device path, file path or URL
    QString name;      ///< as shown: `Simulated camera`, `HD Pro Webcam`

    [[nodiscard]] bool operator==(const SourceAddress&) const = default;
};

enum class SourceState { kStopped, kStarting, kRunning, kPaused, kSilent, kLost };

/// What a camera said of itself when it was opened last. Empty before that.
struct DeviceReport {
    VideoFormat format;                ///< in use
    std::vector<VideoFormat> formats;  ///< to choose from, best layout first; empty: the source has no choice
    std::vector<CameraControlState> controls;

    [[nodiscard]] bool operator==(const DeviceReport&) const = default;
};

/// A picture taken in another mode than the live one, and what it cost.
struct FullStill {
    camera::FramePtr frame;
    core::Duration took{0};  ///< from the wish until the live mode ran again
};

struct SourceStatistics {
    double measured_rate_hz = 0.0;
    std::uint64_t delivered = 0;
    std::uint64_t lost = 0;        ///< gaps in the device's sequence while the gate was open
    std::uint64_t overtaken = 0;   ///< replaced by a newer one before anybody took them
    core::Duration newest_age{0};  ///< capture to delivery of the newest frame
};

/// A live source of frames. The object lives on the GUI thread and never blocks it; the work is on its own
/// worker. The newest frame wins: nothing queues. A watchdog reports a silent source (kSilent after
/// `watchdog`) and tries to reopen it when the device is back.
class VideoSource : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    virtual void start(const VideoFormat& wanted) = 0;
    virtual void stop() = 0;  ///< releases the device; returns at once
    /// Keeps the device running and delivers nothing until resume(); also for a device that is lost meanwhile.
    virtual void pause() {}
    virtual void resume() {}
    /// Sets them soon, and again whenever the device is opened again. Wishes the device cannot meet are left out.
    virtual void setControls(const std::vector<ControlValue>& wishes) { Q_UNUSED(wishes) }
    /// One picture in this mode, then the live mode again: stillTaken() or stillFailed(). The live view stands still
    /// meanwhile.
    virtual void takeStill(const VideoFormat& mode) { Q_UNUSED(mode) }
    [[nodiscard]] virtual DeviceReport report() const { return {}; }
    [[nodiscard]] virtual SourceAddress address() const = 0;
    [[nodiscard]] virtual SourceState state() const = 0;
    [[nodiscard]] virtual SourceStatistics statistics() const = 0;
    /// The newest frame, or null before the first. Callable from any thread.
    [[nodiscard]] virtual camera::FramePtr newestFrame() const = 0;

Q_SIGNALS:
    /// Queued to the receiver's thread; take newestFrame() there. Emitted again only after the last one was
    /// taken (no backlog).
    void frameReady();
    void stateChanged(pmts::video::SourceState state);
    void problemReported(const pmts::core::Error& error);
    void reportChanged();  ///< take report(): another mode, or a control has moved
    void stillTaken(const pmts::video::FullStill& still);
    void stillFailed(const pmts::core::Error& error);
};

/// Cameras present now: V4L2 nodes and Qt Multimedia devices, each once. Does not open them for long; safe on
/// the GUI thread.
[[nodiscard]] std::vector<SourceAddress> presentCameras();

/// A source for an address; kSimulated needs a FramePainter and is made by SimulatedSource instead. Throws
/// std::logic_error for it.
[[nodiscard]] std::unique_ptr<VideoSource> makeVideoSource(const SourceAddress& address,
                                                           core::VideoGate& gate);

/// Draws what a simulated camera sees at a moment; called on the source's worker thread. The simulator's
/// camera fits in here.
using FramePainter = std::function<camera::Frame(core::Duration captured_at)>;
[[nodiscard]] std::unique_ptr<VideoSource> makeSimulatedSource(FramePainter painter, core::VideoGate& gate);

/// How a simulated camera with modes and controls is set: its painter draws accordingly.
struct SimulatedExposure {
    QSize size{1280, 720};
    double exposure_ms = 10.0;  ///< 10 ms at gain 1 is right for the scene
    double gain = 1.0;
    double out_of_focus = 0.0;  ///< steps of the focus away from the sharp place

    [[nodiscard]] bool operator==(const SimulatedExposure&) const = default;
};
using ExposurePainter = std::function<camera::Frame(core::Duration captured_at, const SimulatedExposure& setting)>;
[[nodiscard]] std::unique_ptr<VideoSource> makeSimulatedSource(ExposurePainter painter, core::VideoGate& gate);

}  // namespace pmts::video
