#pragma once

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>

namespace pmts::test {

/// Runs the event loop in real time until it is so: for what threads and the pool do. Fails with a sentence when it is not
/// so within the limit, instead of standing until the whole program is ended.
[[nodiscard]] inline testing::AssertionResult runUntil(const std::function<bool()>& so,
                                                       std::chrono::milliseconds limit = std::chrono::seconds(60)) {
    bool is_late = false;
    QTimer watch;
    watch.setSingleShot(true);
    QObject::connect(&watch, &QTimer::timeout, [&is_late] { is_late = true; });
    watch.start(limit);
    QTimer look;  // threads need not send an event when it is so
    look.start(std::chrono::milliseconds(10));
    while (!so()) {
        if (is_late) {
            return testing::AssertionFailure() << "what was waited for did not happen within " << limit.count() << " ms";
        }
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return testing::AssertionSuccess();
}

}  // namespace pmts::test
