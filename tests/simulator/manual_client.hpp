#pragma once

#include <string>
#include <vector>

namespace pmts::simulator {

/// A program somebody wrote with the maker's manual on the table and nothing of PMTS: opens a serial port,
/// sends a line with CR LF, reads one byte after the other until `>`. Blocks its thread; gives up after ten
/// seconds of silence.
class ManualClient {
public:
    explicit ManualClient(const std::string& port);
    ~ManualClient();
    ManualClient(const ManualClient&) = delete;
    ManualClient& operator=(const ManualClient&) = delete;

    [[nodiscard]] bool isOpen() const { return fd_ >= 0; }
    /// The lines of the answer without their CR LF and without `>`; {"(silence)"} when no `>` came.
    std::vector<std::string> ask(const std::string& command);
    /// Data of one label out of an answer, empty when it is not there.
    static std::string label(const std::vector<std::string>& answer, const std::string& number);
    /// Nothing but `>` came.
    bool accepts(const std::string& command) { return ask(command).empty(); }

private:
    int fd_;
};

}  // namespace pmts::simulator
