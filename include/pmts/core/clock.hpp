#pragma once

#include <QDateTime>

#include <chrono>
#include <functional>
#include <memory>

namespace pmts::core {

using Duration = std::chrono::nanoseconds;

/// A pending action of a Clock. Destroying or cancelling it before it is due means it never runs.
class Timer {
public:
    class Impl {
    public:
        virtual ~Impl() = default;
    };

    Timer() = default;
    explicit Timer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

    void cancel() { impl_.reset(); }

private:
    std::unique_ptr<Impl> impl_;
};

/// The only source of time. Everything that waits takes one by reference, so that tests run hours in seconds.
/// Each thread with an event loop has its own; now() of all SystemClocks agrees (steady_clock).
class Clock {
public:
    virtual ~Clock() = default;

    /// Monotonic time since an arbitrary origin, the same for all clocks of a process.
    [[nodiscard]] virtual Duration now() const = 0;
    [[nodiscard]] virtual QDateTime utcNow() const = 0;
    /// Runs the action once on the calling thread's event loop, not before `delay` has passed.
    [[nodiscard]] virtual Timer callAfter(Duration delay, std::function<void()> action) = 0;
};

/// The machine's clock. Millisecond timers, nanosecond reading. Usable from any thread with an event loop.
class SystemClock final : public Clock {
public:
    [[nodiscard]] Duration now() const override;
    [[nodiscard]] QDateTime utcNow() const override;
    [[nodiscard]] Timer callAfter(Duration delay, std::function<void()> action) override;
};

}  // namespace pmts::core
