#include "pmts/instrument/pointing_poller.hpp"

#include "pmts/core/task.hpp"
#include "pmts/instrument/geodimeter_driver.hpp"
#include "standing_warnings.hpp"

#include <algorithm>
#include <stop_token>

namespace pmts::instrument {

/// One run from start() to stop(), shared with the coroutine that may outlive the poller by one answer.
class PointingPoller::Loop {
public:
    Loop(PointingPoller& poller, core::Clock& clock)
        : poller_(&poller), clock_(clock), settings_(poller.settings_) {}

    static core::Task<void> run(std::shared_ptr<Loop> loop) {
        while (loop->poller_ != nullptr) {
            const core::Duration began_at = loop->clock_.now();
            if (!loop->poller_->driver_.isBusy()) {
                auto polling = loop->poller_->driver_.pollPointing(loop->stop_.get_token());
                const auto pointing = co_await polling;
                if (loop->poller_ == nullptr) {
                    co_return;  // stopped meanwhile: driver and clock may be gone
                }
                loop->judge(pointing);
            }
            auto pausing = core::sleepFor(loop->clock_, loop->pauseAfter(began_at), loop->stop_.get_token());
            if (const auto paused = co_await pausing; !paused) {
                co_return;
            }
        }
    }

    void end() {
        poller_ = nullptr;
        stop_.request_stop();
    }

private:
    /// Only an instrument that says nothing is silent: an info code or a damaged answer is an answer. One that has lost its
    /// settings is another instrument: its units and block end have to be asked for.
    void judge(const core::Result<geometry::Pointing>& pointing) {
        const bool unanswered = !pointing && pointing.error().kind == core::ErrorKind::kTimeOut;
        const bool refused = !pointing && (pointing.error().kind == core::ErrorKind::kRefused ||
                                           pointing.error().kind == core::ErrorKind::kCancelled);
        if (refused) {
            return;
        }
        failures_ = pointing ? 0 : failures_ + 1;
        unanswered_ = unanswered ? unanswered_ + 1 : 0;
        const bool begins_anew = !pointing && pointing.error().info_code && meansLostSettings(*pointing.error().info_code);
        if ((begins_anew || unanswered_ == settings_.failures_to_silence) && poller_ != nullptr && poller_->on_silence) {
            poller_->on_silence(pointing.error());
        }
    }

    [[nodiscard]] core::Duration pauseAfter(core::Duration began_at) const {
        const core::Duration backed_off = settings_.interval * (1LL << std::min(failures_, 10));
        const auto interval =
            failures_ == 0 ? settings_.interval : std::min(backed_off, settings_.longest_back_off);
        return std::max(began_at + interval - clock_.now(), core::Duration(std::chrono::milliseconds(1)));
    }

    PointingPoller* poller_;
    core::Clock& clock_;
    PollerSettings settings_;
    std::stop_source stop_;
    int failures_ = 0;
    int unanswered_ = 0;
};

PointingPoller::PointingPoller(GeodimeterDriver& driver, core::Clock& clock, PollerSettings settings)
    : driver_(driver), clock_(clock), settings_(settings) {}

PointingPoller::~PointingPoller() { stop(); }

void PointingPoller::start() {
    if (loop_ == nullptr) {
        loop_ = std::make_shared<Loop>(*this, clock_);
        [[maybe_unused]] const auto running = Loop::run(loop_);  // runs on by itself until stop()
    }
}

void PointingPoller::stop() {
    if (const auto loop = std::exchange(loop_, nullptr)) {
        loop->end();
    }
}

bool PointingPoller::isRunning() const { return loop_ != nullptr; }

}  // namespace pmts::instrument
