#pragma once

#include <QEventLoop>
#include <QProcess>

namespace pmts::test {

/// Turns the event loop until the program says something or ends. No limit of its own: ctest ends a hang.
inline void awaitSign(QProcess& program) {
    QEventLoop loop;
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
