#pragma once

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <termios.h>
#include <unistd.h>

namespace pmts::bench {

/// The far end of a port under test: a pty's master in raw mode, which stays readable between clients.
class PtyEnd {
public:
    PtyEnd() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
        if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0) {
            std::perror("pty");
            std::exit(1);
        }
        name_ = ptsname(master_);
        keeper_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY);
        termios raw{};
        tcgetattr(keeper_, &raw);
        cfmakeraw(&raw);
        tcsetattr(keeper_, TCSANOW, &raw);
    }
    ~PtyEnd() {
        ::close(keeper_);
        ::close(master_);
    }
    PtyEnd(const PtyEnd&) = delete;
    PtyEnd& operator=(const PtyEnd&) = delete;

    [[nodiscard]] int fd() const { return master_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    void say(std::string_view text) const {
        if (::write(master_, text.data(), text.size()) < 0) {
            std::perror("write");
        }
    }

private:
    int master_;
    int keeper_ = -1;
    std::string name_;
};

}  // namespace pmts::bench
