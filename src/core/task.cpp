#include "pmts/core/task.hpp"

#include <QAbstractEventDispatcher>

namespace pmts::core {
namespace {

/// Of the actions that went through post() on this thread.
thread_local PostCounts post_counts;

}  // namespace

PostCounts postCounts() { return post_counts; }

void post(std::function<void()> action) {
    auto* loop = QAbstractEventDispatcher::instance();
    if (loop == nullptr) {
        throw std::logic_error("a coroutine is awaited on a thread without an event loop");
    }
    ++post_counts.posted;
    QMetaObject::invokeMethod(
        loop,
        [action = std::move(action)] {
            ++post_counts.run;
            action();
        },
        Qt::QueuedConnection);
}

Task<Result<void>> sleepFor(Clock& clock, Duration span, std::stop_token stop) {
    if (stop.stop_requested()) {
        co_return cancelled();
    }
    Completion<void> done;
    const Timer timer = clock.callAfter(span, [done] { done.complete({}); });
    const std::stop_callback on_stop(stop, [done] { done.complete(cancelled()); });
    auto answer = done.answer();
    co_return co_await answer;
}

}  // namespace pmts::core
