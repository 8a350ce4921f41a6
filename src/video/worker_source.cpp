#include "worker_source.hpp"

#include "pmts/core/logging.hpp"

#include <algorithm>

namespace pmts::video {
namespace {

constexpr core::Duration kParting = std::chrono::milliseconds(300);

}  // namespace

WorkerSource::WorkerSource(SourceAddress address, DeviceFactory make_device, core::VideoGate& gate,
                           WorkerTimes times)
    : address_(std::move(address)),
      make_device_(std::move(make_device)),
      gate_(gate),
      times_(times),
      outlet_(std::make_shared<Outlet>(*this, gate)) {
    const auto tick = std::chrono::duration_cast<std::chrono::milliseconds>(times.silent_after / 8);
    watchdog_.setInterval(std::max(tick, std::chrono::milliseconds(10)));
    connect(&watchdog_, &QTimer::timeout, this, &WorkerSource::watch);
}

WorkerSource::~WorkerSource() {
    outlet_->close();
    retireRun();
    const core::Duration latest = now() + kParting;
    for (const auto& run : retired_) {  // a worker stuck in a driver ends by itself, later
        if (!run->finishWithin(std::max(latest - now(), core::Duration(0)))) {
            run->abandon();
        }
    }
}

void WorkerSource::start(const VideoFormat& wanted) {
    retireRun();
    wanted_ = wanted;
    last_problem_.clear();
    paused_ = false;
    enter(SourceState::kStarting);
    startRun();
    watchdog_.start();
}

void WorkerSource::stop() {
    watchdog_.stop();
    retireRun();
    (void)slot_->renew();
    enter(SourceState::kStopped);
}

void WorkerSource::pause() {
    paused_ = true;
    if (run_) {
        run_->setPaused(true);
    }
}

void WorkerSource::resume() {
    paused_ = false;
    if (run_) {
        run_->setPaused(false);
    }
}

void WorkerSource::setControls(const std::vector<ControlValue>& wishes) {
    wishes_ = wishes;
    if (run_) {
        run_->setControls(wishes);
    }
    std::erase_if(wishes_, [](const ControlValue& wish) { return wish.hold; });  // for the device that is open now
}

void WorkerSource::takeStill(const VideoFormat& mode) {
    if (run_) {
        return run_->requestStill(mode);
    }
    Q_EMIT stillFailed({core::ErrorKind::kCamera, tr("The camera is stopped."), tr("Start it first."), std::nullopt, {}});
}

void WorkerSource::startRun() {
    run_ = std::make_shared<WorkerRun>(make_device_(), wanted_, times_, slot_, slot_->renew(), outlet_);
    run_->setControls(wishes_);
    run_->setPaused(paused_);
    run_->start(notices(), retired_.empty() ? nullptr : retired_.back());
}

WorkerRun::Notices WorkerSource::notices() {
    const std::weak_ptr<WorkerRun> run = run_;
    const auto if_current = [this, run](auto action) {
        return [this, run, action](const auto& news) {
            if (run_ != nullptr && run.lock() == run_) {
                action(news);
            }
        };
    };
    return {.frame_ready =
                [this] {
                    if (slot_->noticeArrived()) {
                        Q_EMIT frameReady();
                    }
                },
            .state_changed = if_current([this](SourceState state) { enter(state); }),
            .problem = if_current([this](const core::Error& error) { tellProblem(error); }),
            .report = if_current([this](const DeviceReport& news) {
                report_ = news;
                Q_EMIT reportChanged();
            }),
            .still = if_current([this](const FullStill& still) { Q_EMIT stillTaken(still); }),
            .no_still = if_current([this](const core::Error& error) { Q_EMIT stillFailed(error); })};
}

void WorkerSource::retireRun() {
    std::erase_if(retired_, [](const auto& run) { return run->finishWithin(core::Duration(0)); });
    if (run_) {
        run_->requestStop();
        retired_.push_back(std::exchange(run_, nullptr));
    }
}

/// Frames count as a sign of life also while the gate drops them, so the gate never makes a source silent.
void WorkerSource::watch() {
    const core::Duration at = now();
    const bool expects_frames = state_ == SourceState::kStarting || state_ == SourceState::kRunning ||
                                state_ == SourceState::kPaused || state_ == SourceState::kSilent;
    if (!expects_frames || !gate_.isOpen() || at - run_->lastFrameAt() < times_.silent_after) {
        return;
    }
    if (state_ != SourceState::kSilent) {
        enter(SourceState::kSilent);
        tellProblem(silence());
    }
    if (at - run_->lastTurnAt() > times_.abandon_after) {
        retireRun();
        startRun();
    } else if (at - asked_to_reopen_at_ > times_.silent_after) {
        asked_to_reopen_at_ = at;
        run_->requestReopen();
    }
}

void WorkerSource::enter(SourceState state) {
    if (state == SourceState::kRunning) {
        last_problem_.clear();
    }
    if (state_ != state) {
        state_ = state;
        Q_EMIT stateChanged(state);
    }
}

void WorkerSource::tellProblem(const core::Error& error) {
    if (error.sentence() != last_problem_) {
        last_problem_ = error.sentence();
        qCWarning(core::logVideo).noquote() << error.sentence() << error.detail;
        Q_EMIT problemReported(error);
    }
}

core::Error WorkerSource::silence() const {
    const double seconds = std::chrono::duration<double>(times_.silent_after).count();
    return {core::ErrorKind::kCamera,
            tr("%1 has sent no picture for %2 s.").arg(address_.name).arg(seconds, 0, 'g', 2),
            tr("PMTS restarts it by itself; if that does not help, unplug it and plug it in again."),
            std::nullopt, address_.location};
}

}  // namespace pmts::video
