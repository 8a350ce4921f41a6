#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <functional>
#include <optional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pmts::job {

/// Another process, forked from the test, that reports numbers through a pipe.
class OtherProcess {
public:
    using Say = std::function<void(int)>;

    explicit OtherProcess(const std::function<void(const Say&)>& work) {
        int ends[2] = {};
        EXPECT_EQ(::pipe(ends), 0);
        process_ = ::fork();
        if (process_ == 0) {
            ::close(ends[0]);
            work([&](int number) { (void)!::write(ends[1], &number, sizeof number); });
            ::_exit(0);
        }
        ::close(ends[1]);
        reading_end_ = ends[0];
    }
    ~OtherProcess() {
        kill();
        ::close(reading_end_);
    }
    OtherProcess(const OtherProcess&) = delete;
    OtherProcess& operator=(const OtherProcess&) = delete;

    /// Waits for the next number; nothing when the process has ended.
    std::optional<int> next() {
        int number = 0;
        return ::read(reading_end_, &number, sizeof number) == sizeof number ? std::optional(number)
                                                                             : std::nullopt;
    }
    /// Waits until it has ended by itself: the signal that ended it, 0 when none did.
    int endedBySignal() {
        int status = 0;
        ::waitpid(process_, &status, 0);
        process_ = -1;
        return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }
    /// kill -9, and waits until it is dead.
    void kill() {
        if (process_ > 0) {
            ::kill(process_, SIGKILL);
            ::waitpid(process_, nullptr, 0);
            process_ = -1;
        }
    }

private:
    pid_t process_ = -1;
    int reading_end_ = -1;
};

/// The kernel kills this process in the middle of the write that would make a file longer than this.
inline void dieAtFileSize(rlim_t bytes) {
    const rlimit no_core{0, 0};
    (void)::setrlimit(RLIMIT_CORE, &no_core);
    const rlimit limit{bytes, RLIM_INFINITY};
    (void)::setrlimit(RLIMIT_FSIZE, &limit);
}

/// The disk takes no byte past this size of a file, in this process: what a full disk looks like from inside.
inline void limitFileSize(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, RLIM_INFINITY};
    (void)::setrlimit(RLIMIT_FSIZE, &limit);
}

}  // namespace pmts::job
