#pragma once

#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>

#include <functional>
#include <stdexcept>

namespace pmts::bench {

/// Runs the event loop until it is so; throws when it is not after half a minute.
inline void runUntil(const std::function<bool()>& so) {
    QEventLoop loop;
    QTimer tick;
    QElapsedTimer passed;
    passed.start();
    QObject::connect(&tick, &QTimer::timeout, &loop, [&] {
        if (so() || passed.hasExpired(30000)) {
            loop.quit();
        }
    });
    tick.start(2);
    loop.exec();
    if (!so()) {
        throw std::runtime_error("the program did not get there in half a minute");
    }
}

}  // namespace pmts::bench
