#pragma once

#include <QEventLoop>
#include <QProcess>
#include <QTimer>
#include <gtest/gtest.h>

#include <chrono>

namespace pmts::test {

/// Turns the event loop until the program says something or ends. One that does neither for five minutes is ended, and the
/// test fails with a sentence.
inline void awaitSign(QProcess& program) {
    QEventLoop loop;
    QTimer late;
    late.setSingleShot(true);
    QObject::connect(&late, &QTimer::timeout, &loop, [&program, &loop] {
        ADD_FAILURE() << program.program().toStdString() << " said nothing for five minutes and was ended.";
        program.kill();
        loop.quit();
    });
    late.start(std::chrono::minutes(5));
    QObject::connect(&program, &QProcess::readyReadStandardOutput, &loop, &QEventLoop::quit);
    QObject::connect(&program, &QProcess::finished, &loop, &QEventLoop::quit);
    QObject::connect(&program, &QProcess::errorOccurred, &loop, &QEventLoop::quit);
    if (program.state() != QProcess::NotRunning) {
        loop.exec();
    }
}

/// The next line of its standard output; empty when it ended without one.
inline QString nextLineOf(QProcess& program) {
    while (!program.canReadLine() && program.state() != QProcess::NotRunning) {
        awaitSign(program);
    }
    return QString::fromLocal8Bit(program.readLine()).trimmed();
}

inline void awaitEnd(QProcess& program) {
    while (program.state() != QProcess::NotRunning) {
        awaitSign(program);
    }
}

}  // namespace pmts::test
