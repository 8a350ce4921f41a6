#include "worker_run.hpp"

#include <QCoreApplication>
#include <QMetaObject>

#include <pthread.h>

namespace pmts::video {
namespace {

constexpr core::Duration kTurn = std::chrono::milliseconds(100);
constexpr core::Duration kStillLimit = std::chrono::seconds(4);
constexpr int kSettlingFrames = 2;  ///< after a change of mode the first ones are often dark

}  // namespace

core::Duration now() { return core::SystemClock().now(); }

void Outlet::close() {
    const std::lock_guard lock(mutex_);
    source_ = nullptr;
    gate_ = nullptr;
}

void Outlet::post(std::function<void()> action) {
    const std::lock_guard lock(mutex_);
    if (source_ != nullptr) {
        QMetaObject::invokeMethod(source_, std::move(action), Qt::QueuedConnection);
    }
}

bool Outlet::admitsFrame() {
    const std::lock_guard lock(mutex_);
    if (gate_ == nullptr) {
        return false;
    }
    if (!gate_->isOpen()) {
        gate_->countDroppedFrame();
        return false;
    }
    return true;
}

WorkerRun::WorkerRun(std::unique_ptr<CaptureDevice> device, VideoFormat wanted, WorkerTimes times,
                     std::shared_ptr<FrameSlot> slot, unsigned slot_run, std::shared_ptr<Outlet> outlet)
    : device_(std::move(device)),
      wanted_(std::move(wanted)),
      times_(times),
      slot_(std::move(slot)),
      slot_run_(slot_run),
      outlet_(std::move(outlet)),
      last_frame_ns_(now().count()),
      last_turn_ns_(now().count()) {}

void WorkerRun::start(Notices notices, std::shared_ptr<WorkerRun> before) {
    notices_ = std::move(notices);
    before_ = std::move(before);
    thread_ = std::thread([self = shared_from_this()] {
        pthread_setname_np(pthread_self(), "pmts-camera");
        self->work();
    });
}

void WorkerRun::requestStop() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    changed_.notify_all();
    device_->interrupt();
}

void WorkerRun::requestReopen() {
    reopen_ = true;
    device_->interrupt();
}

void WorkerRun::setPaused(bool paused) { paused_ = paused; }

void WorkerRun::setControls(std::vector<ControlValue> wishes) {
    {
        const std::lock_guard lock(mutex_);
        wishes_ = std::move(wishes);
        wishes_are_new_ = true;
    }
    device_->interrupt();
}

void WorkerRun::requestStill(const VideoFormat& mode) {
    {
        const std::lock_guard lock(mutex_);
        still_mode_ = mode;
    }
    device_->interrupt();
}

bool WorkerRun::finishWithin(core::Duration limit) {
    const bool ended = waitEnded(limit);
    if (ended && thread_.joinable()) {
        thread_.join();
    }
    return ended;
}

bool WorkerRun::waitEnded(core::Duration limit) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, limit, [this] { return ended_; });
}

void WorkerRun::work() {
    if (before_) {
        while (!stop_ && !before_->waitEnded(kTurn) && now() - before_->lastTurnAt() < times_.abandon_after) {
        }
        before_.reset();
    }
    while (!stop_) {
        try {
            capture();
        } catch (const std::exception& failure) {  // a decoder or painter gave up
            reportLoss({core::ErrorKind::kCamera,
                        QCoreApplication::translate("VideoSource", "The camera's picture could not be read."),
                        QCoreApplication::translate("VideoSource", "The live view tries again by itself."),
                        std::nullopt, QString::fromUtf8(failure.what())});
            (void)waitToReopen();
        }
    }
    device_->close();
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    changed_.notify_all();
}

void WorkerRun::capture() {
    while (!stop_) {
        last_turn_ns_ = now().count();
        if (reopen_.exchange(false) && open_) {
            closeDevice();
        }
        if (!open_ && !openDevice()) {
            if (!waitToReopen()) {
                return;
            }
            continue;
        }
        followOrders();
        if (open_) {
            takeShot();
        }
    }
}

bool WorkerRun::openDevice() {
    last_sequence_.reset();
    const auto opened = device_->open(wanted_);
    if (!opened) {
        reportLoss(opened.error());
        return false;
    }
    open_ = true;
    last_frame_ns_ = now().count();  // the watchdog's patience starts here
    reopen_ = false;                 // what was asked for while it was opening is done
    applyControls();
    if (std::exchange(lost_, false)) {
        announce(SourceState::kStarting);
    }
    return true;
}

void WorkerRun::closeDevice() {
    device_->close();
    open_ = false;
    shown_.reset();  // the next frame says that it runs again
}

void WorkerRun::takeShot() {
    const auto shot = device_->next(kTurn);
    if (!shot) {
        reportLoss(shot.error());
        (void)waitToReopen();
    } else if (*shot && !stop_) {
        last_frame_ns_ = now().count();
        deliver(**shot);
    }
}

void WorkerRun::deliver(const Shot& shot) {
    const std::uint64_t expected = last_sequence_ ? *last_sequence_ + 1 : shot.sequence;
    const std::uint64_t missed = shot.sequence > expected ? shot.sequence - expected : 0;
    last_sequence_ = shot.sequence;
    if (paused_) {
        if (shown_ != SourceState::kPaused) {
            shown_ = SourceState::kPaused;
            announce(SourceState::kPaused);
        }
        return;
    }
    if (!outlet_->admitsFrame()) {
        return;
    }
    slot_->countLost(missed);
    camera::Frame frame = device_->picture();
    if (frame.image.empty()) {
        slot_->countLost(1);
        return;
    }
    frame.captured_at = shot.captured_at;
    frame.sequence = shot.sequence;
    if (stop_) {
        return;
    }
    if (shown_ != SourceState::kRunning) {
        shown_ = SourceState::kRunning;
        announce(SourceState::kRunning);
    }
    if (slot_->put(std::make_shared<const camera::Frame>(std::move(frame)), now(), slot_run_)) {
        outlet_->post([self = shared_from_this()] { self->notices_.frame_ready(); });
    }
}

/// What the source's thread has asked for since the last turn; the device is open.
void WorkerRun::followOrders() {
    std::optional<VideoFormat> mode;
    bool has_wishes = false;
    {
        const std::lock_guard lock(mutex_);
        mode = std::exchange(still_mode_, std::nullopt);
        has_wishes = std::exchange(wishes_are_new_, false);
    }
    if (has_wishes) {
        applyControls();
    }
    if (mode) {
        takeStill(*mode);
    }
}

void WorkerRun::applyControls() {
    std::vector<ControlValue> wishes;
    {
        const std::lock_guard lock(mutex_);
        wishes = wishes_;
        wishes_are_new_ = false;
    }
    for (const ControlValue& wish : wishes) {
        device_->setControl(wish);
    }
    tellReport();
}

void WorkerRun::tellReport() {
    const DeviceReport report = device_->report();
    if (!(report == report_)) {
        report_ = report;
        outlet_->post([self = shared_from_this(), report] { self->notices_.report(report); });
    }
}

void WorkerRun::takeStill(const VideoFormat& mode) {
    const core::Duration asked_at = now();
    const auto still = stillIn(mode);
    closeDevice();
    if (!openDevice()) {
        (void)waitToReopen();
    }
    if (still) {
        outlet_->post([self = shared_from_this(), shot = FullStill{*still, now() - asked_at}] { self->notices_.still(shot); });
    } else {
        outlet_->post([self = shared_from_this(), error = still.error()] { self->notices_.no_still(error); });
    }
}

core::Result<camera::FramePtr> WorkerRun::stillIn(const VideoFormat& mode) {
    closeDevice();
    PMTS_TRY(device_->open(mode));
    open_ = true;
    applyControls();
    int seen = 0;
    for (const core::Duration latest = now() + kStillLimit; now() < latest && !stop_;) {
        last_turn_ns_ = last_frame_ns_ = now().count();
        const auto shot = device_->next(kTurn);
        PMTS_TRY(shot);
        camera::Frame frame;
        if (*shot) {
            frame = device_->picture();
        }
        if (!frame.image.empty() && ++seen > kSettlingFrames) {
            frame.captured_at = (*shot)->captured_at;
            frame.sequence = (*shot)->sequence;
            return std::make_shared<const camera::Frame>(std::move(frame));
        }
    }
    return core::fail(core::ErrorKind::kCamera,
                      QCoreApplication::translate("VideoSource", "The camera gave no picture at full resolution."),
                      QCoreApplication::translate("VideoSource", "Take the photo from the live picture."));
}

void WorkerRun::reportLoss(const core::Error& error) {
    if (stop_) {
        return;  // nobody waits for it any more
    }
    if (open_) {
        closeDevice();
    }
    lost_ = true;
    announce(SourceState::kLost);
    outlet_->post([self = shared_from_this(), error] { self->notices_.problem(error); });
}

void WorkerRun::announce(SourceState state) {
    outlet_->post([self = shared_from_this(), state] { self->notices_.state_changed(state); });
}

/// False when the worker is to stop.
bool WorkerRun::waitToReopen() {
    std::unique_lock lock(mutex_);
    return !changed_.wait_for(lock, times_.reopen_every, [this] { return stop_.load(); });
}

}  // namespace pmts::video
