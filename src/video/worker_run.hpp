#pragma once

#include "capture_device.hpp"
#include "frame_slot.hpp"
#include "pmts/core/video_gate.hpp"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace pmts::video {

/// The way from the workers to their source. It outlives the source: a worker that comes back late finds it
/// closed.
class Outlet {
public:
    Outlet(QObject& source, core::VideoGate& gate) : source_(&source), gate_(&gate) {}

    void close();  ///< the source goes away; nothing of it is touched afterwards
    /// Runs the action on the source's thread, unless the source is gone by then.
    void post(std::function<void()> action);
    /// Whether a frame that has just arrived is wanted; counts it as dropped otherwise.
    [[nodiscard]] bool admitsFrame();

private:
    std::mutex mutex_;
    QObject* source_;
    core::VideoGate* gate_;
};

struct WorkerTimes {
    core::Duration silent_after =
        std::chrono::seconds(2);  ///< no frame: the source is silent and is reopened
    core::Duration reopen_every = std::chrono::seconds(1);    ///< between attempts at a device that is gone
    core::Duration abandon_after = std::chrono::seconds(10);  ///< a worker stuck in a driver is replaced
};

/// One worker thread with one device, from start() to stop(). Shared by its thread and its source: whoever
/// leaves last ends it.
class WorkerRun : public std::enable_shared_from_this<WorkerRun> {
public:
    struct Notices {
        std::function<void()> frame_ready;
        std::function<void(SourceState)> state_changed;
        std::function<void(const core::Error&)> problem;
        std::function<void(const DeviceReport&)> report;
        std::function<void(const FullStill&)> still;
        std::function<void(const core::Error&)> no_still;
    };

    WorkerRun(std::unique_ptr<CaptureDevice> device, VideoFormat wanted, WorkerTimes times,
              std::shared_ptr<FrameSlot> slot, unsigned slot_run, std::shared_ptr<Outlet> outlet);

    /// Starts the thread; it waits for `before`, which may still hold the device. Notices are run on the
    /// source's thread.
    void start(Notices notices, std::shared_ptr<WorkerRun> before);
    void requestStop();
    void requestReopen();
    void setPaused(bool paused);
    /// All wishes; set now and whenever the device is opened.
    void setControls(std::vector<ControlValue> wishes);
    void requestStill(const VideoFormat& mode);
    /// True when the thread has ended by then; its resources are released.
    bool finishWithin(core::Duration limit);
    void abandon() { thread_.detach(); }  ///< stuck in a driver: it ends by itself, later

    [[nodiscard]] core::Duration lastFrameAt() const { return core::Duration(last_frame_ns_.load()); }
    [[nodiscard]] core::Duration lastTurnAt() const { return core::Duration(last_turn_ns_.load()); }

private:
    void work();
    void capture();
    bool openDevice();
    void closeDevice();
    void reportLoss(const core::Error& error);
    void takeShot();
    void deliver(const Shot& shot);
    void followOrders();
    void applyControls();
    void takeStill(const VideoFormat& mode);
    [[nodiscard]] core::Result<camera::FramePtr> stillIn(const VideoFormat& mode);
    void tellReport();
    void announce(SourceState state);
    [[nodiscard]] bool waitToReopen();
    [[nodiscard]] bool waitEnded(core::Duration limit);

    const std::unique_ptr<CaptureDevice> device_;
    const VideoFormat wanted_;
    const WorkerTimes times_;
    const std::shared_ptr<FrameSlot> slot_;
    const unsigned slot_run_;
    const std::shared_ptr<Outlet> outlet_;
    Notices notices_;
    std::shared_ptr<WorkerRun> before_;

    std::thread thread_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool ended_ = false;
    std::vector<ControlValue> wishes_;  ///< the next three under mutex_
    bool wishes_are_new_ = false;
    std::optional<VideoFormat> still_mode_;
    std::atomic<bool> paused_{false};
    std::atomic<bool> stop_{false};
    std::atomic<bool> reopen_{false};
    std::atomic<std::int64_t> last_frame_ns_;
    std::atomic<std::int64_t> last_turn_ns_;

    // Only the worker's:
    bool open_ = false;
    std::optional<SourceState> shown_;  ///< running or paused, once said of the opened device
    DeviceReport report_;
    bool lost_ = false;
    std::optional<std::uint64_t> last_sequence_;
};

}  // namespace pmts::video
