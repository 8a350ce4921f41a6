#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/task.hpp"

#include <deque>
#include <functional>
#include <memory>
#include <vector>

namespace pmts::transport {

/// Hands items out in their order, none before it is due, always from the event loop. What is due together
/// comes together. May be destroyed inside deliver().
template <class T>
class TimedQueue {
public:
    using Deliver = std::function<void(std::vector<T>)>;

    TimedQueue(core::Clock& clock, Deliver deliver) : clock_(clock), deliver_(std::move(deliver)) {}
    TimedQueue(const TimedQueue&) = delete;
    TimedQueue& operator=(const TimedQueue&) = delete;

    void push(core::Duration due, T item) {
        items_.push_back({std::max(due, last_due_), std::move(item)});
        last_due_ = items_.back().due;
        if (!armed_) {
            arm();
        }
    }

    void clear() {
        items_.clear();
        last_due_ = core::Duration{0};
    }

    [[nodiscard]] bool isEmpty() const { return items_.empty(); }

private:
    struct Entry {
        core::Duration due;
        T item;
    };

    void arm() {
        armed_ = !items_.empty();
        if (!armed_) {
            return;
        }
        const core::Duration wait = items_.front().due - clock_.now();
        if (wait > core::Duration::zero()) {
            timer_ = clock_.callAfter(wait, [this] { deliverDue(); });
            return;
        }
        core::post([this, alive = std::weak_ptr<bool>(alive_)] {
            if (!alive.expired()) {
                deliverDue();
            }
        });
    }

    void deliverDue() {
        std::vector<T> due;
        while (!items_.empty() && items_.front().due <= clock_.now()) {
            due.push_back(std::move(items_.front().item));
            items_.pop_front();
        }
        arm();
        if (!due.empty()) {
            const Deliver deliver = deliver_;  // deliver() may destroy this
            deliver(std::move(due));
        }
    }

    core::Clock& clock_;
    Deliver deliver_;
    std::deque<Entry> items_;
    core::Duration last_due_{0};
    core::Timer timer_;
    bool armed_ = false;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace pmts::transport
