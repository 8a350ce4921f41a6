#include "pmts/core/clock.hpp"

#include <QTimer>

namespace pmts::core {
namespace {

class QtTimer final : public Timer::Impl {
public:
    QtTimer(Duration delay, std::function<void()> action) {
        timer_.setSingleShot(true);
        timer_.setTimerType(Qt::PreciseTimer);
        // The action may destroy this timer: run it from a copy.
        QObject::connect(&timer_, &QTimer::timeout, &timer_, [action = std::move(action)] {
            const auto keep = action;
            keep();
        });
        timer_.start(std::chrono::ceil<std::chrono::milliseconds>(std::max(delay, Duration::zero())));
    }

private:
    QTimer timer_;
};

}  // namespace

Duration SystemClock::now() const { return std::chrono::steady_clock::now().time_since_epoch(); }

QDateTime SystemClock::utcNow() const { return QDateTime::currentDateTimeUtc(); }

Timer SystemClock::callAfter(Duration delay, std::function<void()> action) {
    return Timer(std::make_unique<QtTimer>(delay, std::move(action)));
}

}  // namespace pmts::core
