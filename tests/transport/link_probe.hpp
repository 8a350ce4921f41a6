#pragma once

#include "pmts/transport/byte_link.hpp"

#include <QAbstractEventDispatcher>
#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QTimer>

#include <string>
#include <vector>

namespace pmts::test {

/// Runs the event loop until the condition holds; false when a generous limit has passed.
template <class Condition>
[[nodiscard]] bool waitUntil(Condition condition) {
    const QDeadlineTimer limit(std::chrono::seconds(20));
    QTimer wake;
    wake.start(std::chrono::milliseconds(20));  // other threads do not wake this loop
    while (!condition()) {
        if (limit.hasExpired()) {
            return false;
        }
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return true;
}

/// The event loop comes to rest: nothing fires over and over.
[[nodiscard]] inline bool comesToRest() {
    for (int turns = 0; turns < 1000; ++turns) {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        if (!QAbstractEventDispatcher::instance()->processEvents(QEventLoop::AllEvents)) {
            return true;
        }
    }
    return false;
}

/// What a link has said so far.
struct LinkProbe {
    explicit LinkProbe(transport::ByteLink& link) {
        link.on_received = [this](std::string_view bytes) { received += bytes; };
        link.on_lost = [this](const core::Error& error) { losses.push_back(error); };
    }

    std::string received;
    std::vector<core::Error> losses;
};

}  // namespace pmts::test
