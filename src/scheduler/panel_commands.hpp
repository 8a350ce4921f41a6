#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pmts::scheduler {

/// Cuts what the panel sends into commands, every byte kept. A line feed behind the terminator belongs to the
/// command before it.
class PanelCommands {
public:
    explicit PanelCommands(std::string ends) : ends_(std::move(ends)) {}

    struct Taken {
        std::string tail;                   ///< of a command that was handed out before
        std::vector<std::string> commands;  ///< terminator included
        std::string junk;                   ///< longer than any command
    };
    [[nodiscard]] Taken feed(std::string_view bytes);
    /// The tail of a command that has long been done goes in front of the next one.
    void putBack(std::string_view tail) { half_.insert(0, tail); }
    [[nodiscard]] bool hasHalf() const { return !half_.empty(); }
    [[nodiscard]] const std::string& half() const { return half_; }
    [[nodiscard]] std::string takeHalf();

private:
    [[nodiscard]] bool isEnd(char byte) const { return ends_.find(byte) != std::string::npos; }

    std::string ends_;
    std::string half_;
    bool after_end_ = false;
};

/// Motions, measurements, processes and files take their time; to read or to write a label does not.
[[nodiscard]] bool takesLong(std::string_view command);
/// Whether a block can be the answer: data to who reads, no data to who commands, `7=` to `RG,7`. To a bare `RG` any data
/// can: a block of the REG key that comes just then is taken for the answer.
[[nodiscard]] bool canAnswer(std::string_view command, std::string_view block);
/// Without block ends silence is the answer to everything but a question.
[[nodiscard]] bool isQuestion(std::string_view command);

}  // namespace pmts::scheduler
