#include "job_lock.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace pmts::job {
namespace {

QString tr(const char* sentence) { return QCoreApplication::translate("pmts::job", sentence); }

/// Two names of one file (a link, a relative path) must give one lock.
QString lockPath(const QString& job_path) {
    const QFileInfo info(job_path);
    const QString real = info.exists()
                             ? info.canonicalFilePath()
                             : QFileInfo(info.absolutePath()).canonicalFilePath() + u'/' + info.fileName();
    return real + QStringLiteral(".lock");
}

/// The name still leads to the file that was locked: its last owner removes it, and may do so between our
/// open and lock.
bool stillNamed(int descriptor, const QByteArray& path) {
    struct stat locked {};
    struct stat named {};
    return ::fstat(descriptor, &locked) == 0 && ::stat(path.constData(), &named) == 0 &&
           locked.st_ino == named.st_ino && locked.st_dev == named.st_dev;
}

tl::unexpected<core::Error> cannotLock(const QString& job_path, int code) {
    if (code == EWOULDBLOCK) {
        return core::fail(core::ErrorKind::kFile, tr("The job %1 is opened in another PMTS.").arg(job_path),
                          tr("Close it there, or work on a copy."), QStringLiteral("flock: busy"));
    }
    return core::fail(core::ErrorKind::kFile, tr("The folder of %1 cannot be written.").arg(job_path),
                      tr("Choose a folder that you may write to, on a disk with free space."),
                      QString::fromLocal8Bit(std::strerror(code)));
}

}  // namespace

core::Result<JobLock> JobLock::take(const QString& job_path) {
    const QString path = lockPath(job_path);
    const QByteArray name = QFile::encodeName(path);
    for (;;) {
        const int descriptor = ::open(name.constData(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor < 0) {
            return cannotLock(job_path, errno);
        }
        JobLock lock(descriptor, path);
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            const int code = errno;
            lock.path_.clear();  // somebody else's file: not ours to remove
            return cannotLock(job_path, code);
        }
        if (stillNamed(descriptor, name)) {
            return lock;
        }
        lock.path_.clear();
    }
}

JobLock::JobLock(JobLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::exchange(other.path_, {})) {}

JobLock& JobLock::operator=(JobLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    std::swap(path_, other.path_);
    return *this;
}

JobLock::~JobLock() {
    if (descriptor_ < 0) {
        return;
    }
    if (!path_.isEmpty()) {
        ::unlink(
            QFile::encodeName(path_).constData());  // before the lock goes: a later opener sees another inode
    }
    ::close(descriptor_);
}

}  // namespace pmts::job
