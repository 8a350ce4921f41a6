#include "termination.hpp"

#include <QSocketNotifier>

#include <csignal>
#include <sys/signalfd.h>
#include <unistd.h>

namespace pmts::sim {

void onTermination(QObject* owner, std::function<void()> action) {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        sigaddset(&signals, number);
    }
    sigprocmask(SIG_BLOCK, &signals, nullptr);  // they arrive as readable bytes instead
    const int fd = signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK);
    auto* notifier = new QSocketNotifier(fd, QSocketNotifier::Read, owner);
    QObject::connect(notifier, &QSocketNotifier::activated, owner, [fd, action = std::move(action)] {
        signalfd_siginfo arrived{};
        if (::read(fd, &arrived, sizeof arrived) > 0) {
            action();
        }
    });
    QObject::connect(notifier, &QObject::destroyed, [fd] { ::close(fd); });
}

}  // namespace pmts::sim
