#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"

#include <QCoreApplication>
#include <QMetaObject>
#include <QThread>
#include <qcoro/qcorotask.h>

#include <coroutine>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

namespace pmts::core {

/// A routine that gives its turn away at every co_await. It starts at once and, when dropped, runs on by itself.
template <class T>
using Task = QCoro::Task<T>;

/// Runs an action on the event loop of the calling thread, after the events already queued there.
void post(std::function<void()> action);

/// How many actions this thread has posted and run: a virtual clock moves on only when they are the same.
struct PostCounts {
    std::uint64_t posted = 0;
    std::uint64_t run = 0;
};
[[nodiscard]] PostCounts postCounts();

/// One answer that somebody waits for. The first complete() wins; the waiter is resumed through the event loop of
/// the thread that awaits. When the last handle of the completing side goes away unanswered, call cancel() or hold
/// it in a member: a waiter is never left suspended, ~Completion of the last handle answers kCancelled.
/// Handles are cheap copies; one waiter; one thread.
template <class T>
class Completion {
public:
    Completion() : state_(std::make_shared<State>()), owner_(std::make_shared<Owner>(state_)) {}

    /// False when it was answered before.
    bool complete(Result<T> outcome) const { return state_->complete(std::move(outcome)); }
    [[nodiscard]] bool isComplete() const { return state_->outcome.has_value(); }

    /// Awaitable of the answer: `auto answer = completion.answer(); auto outcome = co_await answer;`
    [[nodiscard]] auto answer() const { return Awaiter{state_}; }

private:
    struct State : std::enable_shared_from_this<State> {
        std::optional<Result<T>> outcome;
        std::coroutine_handle<> waiter;

        bool complete(Result<T> value) {
            if (outcome) {
                return false;
            }
            outcome = std::move(value);
            if (waiter) {
                post([self = this->shared_from_this()] { std::exchange(self->waiter, {}).resume(); });
            }
            return true;
        }
    };

    /// Lives as long as somebody can still answer.
    struct Owner {
        explicit Owner(std::shared_ptr<State> s) : state(std::move(s)) {}
        Owner(const Owner&) = delete;
        Owner& operator=(const Owner&) = delete;
        ~Owner() { state->complete(cancelled()); }
        std::shared_ptr<State> state;
    };

    struct Awaiter {
        std::shared_ptr<State> state;

        [[nodiscard]] bool await_ready() const noexcept { return state->outcome.has_value(); }
        void await_suspend(std::coroutine_handle<> waiter) const { state->waiter = waiter; }
        [[nodiscard]] Result<T> await_resume() const { return std::move(*state->outcome); }
    };

    std::shared_ptr<State> state_;
    std::shared_ptr<Owner> owner_;
};

/// Waits on the clock; ends early with kCancelled when the token is stopped. The clock outlives the wait.
[[nodiscard]] Task<Result<void>> sleepFor(Clock& clock, Duration span, std::stop_token stop = {});

}  // namespace pmts::core
