#pragma once

#include <QEventLoop>
#include <QTimer>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <source_location>

namespace pmts::test {

/// Far beyond what a loaded machine takes for anything that a test waits for.
inline constexpr std::chrono::milliseconds kGenerous = std::chrono::seconds(60);

/// Turns the event loop until it is so, looking every few milliseconds. Past `limit` of real time the test fails with a
/// sentence at the caller's line instead of hanging.
inline bool runUntil(const std::function<bool()>& is_so, std::chrono::milliseconds limit = kGenerous,
                     std::source_location caller = std::source_location::current()) {
    const auto latest = std::chrono::steady_clock::now() + limit;
    QTimer look;
    look.start(std::chrono::milliseconds(5));
    while (!is_so()) {
        if (std::chrono::steady_clock::now() > latest) {
            ADD_FAILURE_AT(caller.file_name(), static_cast<int>(caller.line()))
                << "What was waited for has not come within " << limit.count() << " ms.";
            return false;
        }
        QEventLoop loop;
        QObject::connect(&look, &QTimer::timeout, &loop, &QEventLoop::quit);
        loop.exec();
    }
    return true;
}

}  // namespace pmts::test
