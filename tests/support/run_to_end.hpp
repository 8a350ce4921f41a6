#pragma once

#include "pmts/core/task.hpp"
#include "pmts/core/virtual_clock.hpp"

#include <optional>

namespace pmts::test {

namespace detail {

template <class T>
core::Task<void> keepOutcome(core::Task<T> task, std::shared_ptr<std::optional<T>> outcome) {
    *outcome = co_await task;
}

}  // namespace detail

/// Starts a task; its outcome stands there when it has ended.
template <class T>
[[nodiscard]] std::shared_ptr<const std::optional<T>> begun(core::Task<T> task) {
    const auto outcome = std::make_shared<std::optional<T>>();
    auto runner = detail::keepOutcome(std::move(task), outcome);
    return outcome;
}

/// Runs a task on the virtual clock until it ends; nullopt when it has not ended `limit` later.
template <class T>
[[nodiscard]] std::optional<T> runToEnd(core::Task<T> task, core::VirtualClock& clock, core::Duration limit) {
    const auto outcome = std::make_shared<std::optional<T>>();
    auto runner = detail::keepOutcome(std::move(task), outcome);
    const core::Duration latest = clock.now() + limit;
    core::deliverQueuedEvents();
    while (!outcome->has_value() && clock.advanceToNextTimer(latest)) {
        core::deliverQueuedEvents();
    }
    return std::move(*outcome);
}

}  // namespace pmts::test
