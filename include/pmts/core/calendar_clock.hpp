#pragma once

#include "pmts/core/clock.hpp"

#include <QDateTime>

namespace pmts::core {

/// Another clock's time with a calendar that somebody may set wrong: utcNow() jumps, now() and the timers go on as they
/// did. For tests and soak runs.
class CalendarClock final : public Clock {
public:
    explicit CalendarClock(Clock& time) : time_(time) {}

    [[nodiscard]] Duration now() const override { return time_.now(); }
    [[nodiscard]] QDateTime utcNow() const override { return time_.utcNow().addSecs(ahead_s_); }
    [[nodiscard]] Timer callAfter(Duration delay, std::function<void()> action) override {
        return time_.callAfter(delay, std::move(action));
    }
    void jump(std::chrono::seconds by) { ahead_s_ += by.count(); }

private:
    Clock& time_;
    qint64 ahead_s_ = 0;
};

}  // namespace pmts::core
