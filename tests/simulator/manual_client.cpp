#include "manual_client.hpp"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace pmts::simulator {

ManualClient::ManualClient(const std::string& port)
    : fd_(::open(port.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    termios line{};
    if (fd_ < 0 || ::tcgetattr(fd_, &line) != 0) {
        return;
    }
    ::cfmakeraw(&line);
    line.c_cflag = (line.c_cflag & ~static_cast<tcflag_t>(CSIZE | PARENB | CSTOPB)) | CS8 | CLOCAL | CREAD;
    ::cfsetspeed(&line, B9600);
    ::tcsetattr(fd_, TCSANOW, &line);
}

ManualClient::~ManualClient() {
    if (fd_ >= 0) {
        ::close(fd_);
    }
}

std::vector<std::string> ManualClient::ask(const std::string& command) {
    const std::string sent = command + "\r\n";
    if (::write(fd_, sent.data(), sent.size()) != static_cast<ssize_t>(sent.size())) {
        return {"(silence)"};
    }
    std::vector<std::string> lines;
    std::string line;
    for (char byte = 0;;) {
        if (::read(fd_, &byte, 1) != 1) {  // blocks; ctest ends a program that hangs
            return {"(silence)"};
        }
        if (byte == '>') {
            return lines;
        }
        if (byte == '\n') {
            lines.push_back(line.substr(0, line.find('\r')));
            line.clear();
        } else {
            line += byte;
        }
    }
}

std::string ManualClient::label(const std::vector<std::string>& answer, const std::string& number) {
    for (const std::string& line : answer) {
        if (line.starts_with(number + '=')) {
            return line.substr(number.size() + 1);
        }
    }
    return {};
}

}  // namespace pmts::simulator
