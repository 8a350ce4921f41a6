#include "tick_pacer.hpp"

#include "capture_device.hpp"

#include <algorithm>

namespace pmts::video {

void TickPacer::start(double rate_hz) {
    period_ = std::chrono::duration_cast<core::Duration>(
        std::chrono::duration<double>(1.0 / std::clamp(rate_hz, 0.1, 240.0)));
    origin_ = now();
    next_ = 0;
}

std::optional<Tick> TickPacer::wait(core::Duration limit) {
    const core::Duration latest = now() + limit;
    const auto due = [this] { return origin_ + period_ * static_cast<std::int64_t>(next_); };
    if (const core::Duration late = now() - due(); late > period_ * kBuffers) {
        next_ += static_cast<std::uint64_t>(late / period_);
    }
    std::unique_lock lock(mutex_);
    const auto until = std::chrono::steady_clock::time_point(std::min(due(), latest));
    if (woken_.wait_until(lock, until, [this] { return interrupted_; })) {
        interrupted_ = false;
        return std::nullopt;
    }
    if (due() > latest) {
        return std::nullopt;
    }
    const Tick tick{next_, due()};
    ++next_;
    return tick;
}

void TickPacer::interrupt() {
    const std::lock_guard lock(mutex_);
    interrupted_ = true;
    woken_.notify_all();
}

}  // namespace pmts::video
