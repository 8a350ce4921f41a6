#include "pty_device.hpp"

#include <QFile>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

namespace pmts::transport {
namespace {

constexpr std::array<std::pair<speed_t, int>, 12> kSpeeds{{{B300, 300},
                                                           {B600, 600},
                                                           {B1200, 1200},
                                                           {B1800, 1800},
                                                           {B2400, 2400},
                                                           {B4800, 4800},
                                                           {B9600, 9600},
                                                           {B19200, 19200},
                                                           {B38400, 38400},
                                                           {B57600, 57600},
                                                           {B115200, 115200},
                                                           {B230400, 230400}}};

tl::unexpected<core::Error> systemFailure(const QString& happened, const QString& remedy) {
    return core::fail(core::ErrorKind::kPortUnavailable, happened, remedy,
                      QString::fromLocal8Bit(std::strerror(errno)));
}

void makeRaw(int fd) {
    termios line{};
    if (::tcgetattr(fd, &line) == 0) {
        ::cfmakeraw(&line);
        ::tcsetattr(fd, TCSANOW, &line);
    }
}

QString targetOf(const QByteArray& link) {
    char target[PATH_MAX];
    const auto size = ::readlink(link.constData(), target, sizeof target);
    return size < 0 ? QString() : QFile::decodeName(QByteArray(target, static_cast<qsizetype>(size)));
}

}  // namespace

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
    if (this != &other) {
        reset();
        fd_ = std::exchange(other.fd_, -1);
    }
    return *this;
}

void FileDescriptor::reset() {
    if (fd_ >= 0) {
        ::close(std::exchange(fd_, -1));
    }
}

void PtyDevice::resetLine() const {
    ::tcflush(slave.get(), TCIFLUSH);
    ::ioctl(slave.get(), TIOCNXCL);  // a killed client leaves its claim behind
    makeRaw(slave.get());
}

std::optional<PtyClientLine> PtyDevice::line() const {
    termios settings{};
    if (::tcgetattr(slave.get(), &settings) != 0) {
        return std::nullopt;
    }
    const speed_t speed = ::cfgetospeed(&settings);
    const auto known = std::ranges::find(kSpeeds, speed, &std::pair<speed_t, int>::first);
    if (known == kSpeeds.end()) {
        return std::nullopt;
    }
    return PtyClientLine{.baud = known->second,
                         .odd_parity = (settings.c_cflag & PARODD) != 0,
                         .two_stop_bits = (settings.c_cflag & CSTOPB) != 0};
}

core::Result<PtyDevice> openPtyDevice() {
    PtyDevice pty;
    char name[PATH_MAX];
    pty.master = FileDescriptor(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!pty.master.isOpen() || ::grantpt(pty.master.get()) != 0 || ::unlockpt(pty.master.get()) != 0 ||
        ::ptsname_r(pty.master.get(), name, sizeof name) != 0) {
        return systemFailure(QStringLiteral("The system gave no pseudo-terminal."),
                             QStringLiteral("Close programs that use many terminals, then try again."));
    }
    pty.slave = FileDescriptor(::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC));
    if (!pty.slave.isOpen()) {
        return systemFailure(
            QStringLiteral("The pseudo-terminal %1 cannot be opened.").arg(QFile::decodeName(name)), {});
    }
    makeRaw(pty.slave.get());
    pty.slave_name = QFile::decodeName(name);
    return pty;
}

core::Result<void> placeLink(const QString& path, const QString& target) {
    const QByteArray link = QFile::encodeName(path);
    struct stat status {};
    if (::lstat(link.constData(), &status) == 0 && !S_ISLNK(status.st_mode)) {
        return core::fail(core::ErrorKind::kPortUnavailable,
                          QStringLiteral("%1 exists and is not a link.").arg(path),
                          QStringLiteral("Choose another name for the link."));
    }
    const QByteArray fresh = link + '.' + QByteArray::number(::getpid()) + ".new";
    ::unlink(fresh.constData());
    if (::symlink(QFile::encodeName(target).constData(), fresh.constData()) != 0 ||
        ::rename(fresh.constData(), link.constData()) != 0) {
        const auto failure =
            systemFailure(QStringLiteral("The link %1 cannot be made.").arg(path),
                          QStringLiteral("Choose a folder that exists and may be written to."));
        ::unlink(fresh.constData());
        return failure;
    }
    return {};
}

void removeLink(const QString& path, const QString& target) {
    const QByteArray link = QFile::encodeName(path);
    if (targetOf(link) == target) {
        ::unlink(link.constData());
    }
}

}  // namespace pmts::transport
