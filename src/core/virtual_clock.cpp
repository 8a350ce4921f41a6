#include "pmts/core/virtual_clock.hpp"

#include "pmts/core/task.hpp"

#include <QCoreApplication>

#include <stdexcept>

namespace pmts::core {

class VirtualClock::PendingTimer final : public Timer::Impl {
public:
    PendingTimer(std::weak_ptr<Queue> queue, Duration due, std::function<void()> action)
        : queue_(std::move(queue)), alive_(std::make_shared<bool>(true)) {
        queue_.lock()->emplace(due, [alive = std::weak_ptr<bool>(alive_), action = std::move(action)] {
            if (!alive.expired()) {
                action();
            }
        });
    }

private:
    std::weak_ptr<Queue> queue_;
    std::shared_ptr<bool> alive_;
};

QDateTime VirtualClock::utcNow() const {
    // An arbitrary fixed day, so that recorded times are the same in every run.
    static const QDateTime origin(QDate(2026, 6, 1), QTime(6, 0), Qt::UTC);
    return origin.addMSecs(std::chrono::duration_cast<std::chrono::milliseconds>(*now_ + time_of_day_shift_).count());
}

Timer VirtualClock::callAfter(Duration delay, std::function<void()> action) {
    const Duration due = *now_ + std::max(delay, Duration::zero());
    return Timer(std::make_unique<PendingTimer>(queue_, due, std::move(action)));
}

bool VirtualClock::advanceToNextTimer(Duration latest) {
    if (queue_->empty() || queue_->begin()->first > latest) {
        return false;
    }
    auto next = queue_->extract(queue_->begin());
    *now_ = std::max(*now_, next.key());
    next.mapped()();
    return true;
}

void VirtualClock::advance(Duration span) {
    const Duration end = *now_ + span;
    deliverQueuedEvents();
    while (advanceToNextTimer(end)) {
        deliverQueuedEvents();
    }
    *now_ = end;
}

void deliverQueuedEvents() {
    if (QCoreApplication::instance() == nullptr) {
        throw std::logic_error("queued events need a QCoreApplication");
    }
    // Qt delivers in one go only what was queued before: what a delivered event posts needs another round. Without
    // that a chain of answers at one moment would wait for the next timer and a conversation would seem slow.
    PostCounts before;
    do {
        before = postCounts();
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    } while (postCounts().run != before.run && postCounts().run != postCounts().posted);
}

}  // namespace pmts::core
