#pragma once

#include "pmts/core/clock.hpp"

#include <map>

namespace pmts::core {

/// A clock that moves only when told to: tests, soak runs and unattended rehearsals. One thread only.
class VirtualClock final : public Clock {
public:
    [[nodiscard]] Duration now() const override { return *now_; }
    [[nodiscard]] QDateTime utcNow() const override;
    [[nodiscard]] Timer callAfter(Duration delay, std::function<void()> action) override;

    /// The time of day is set; now() does not notice.
    void setTimeOfDayBy(std::chrono::seconds shift) { time_of_day_shift_ += shift; }

    /// Moves on by `span`; timers fall due in order, and queued Qt events are delivered after each of them.
    void advance(Duration span);
    /// Moves to the next timer and runs it. False when no timer is pending or the next is after `latest`.
    bool advanceToNextTimer(Duration latest);

private:
    using Queue = std::multimap<Duration, std::function<void()>>;
    class PendingTimer;

    std::shared_ptr<Duration> now_ = std::make_shared<Duration>(0);
    Duration time_of_day_shift_{0};
    std::shared_ptr<Queue> queue_ = std::make_shared<Queue>();
};

/// Delivers every queued Qt event of this thread, deferred deletions included, until none is left.
void deliverQueuedEvents();

}  // namespace pmts::core
