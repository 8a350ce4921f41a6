#include "pmts/core/task.hpp"

#include <QAbstractEventDispatcher>

namespace pmts::core {

void post(std::function<void()> action) {
    auto* loop = QAbstractEventDispatcher::instance();
    if (loop == nullptr) {
        throw std::logic_error("a coroutine is awaited on a thread without an event loop");
    }
    QMetaObject::invokeMethod(loop, std::move(action), Qt::QueuedConnection);
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
