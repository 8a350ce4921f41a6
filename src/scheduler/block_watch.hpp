#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmts::scheduler {

/// Follows what the instrument says byte by byte: where blocks begin and end, and which are the running stream of
/// the bus dialect. Gives every byte back, in order; only a head that may become a stream's waits for its next byte.
class BlockWatch {
public:
    explicit BlockWatch(std::string stream_head) : stream_head_(std::move(stream_head)) {}

    struct Piece {
        std::string bytes;
        bool begins = false;   ///< first bytes of a block
        bool ends = false;     ///< the last one is the end mark
        bool streams = false;  ///< answers nobody
        std::string block{};   ///< at the end: the whole, without its end mark
    };
    [[nodiscard]] std::vector<Piece> feed(std::string_view bytes);
    void setEndMark(std::optional<char> end_mark) { end_mark_ = end_mark; }
    [[nodiscard]] std::optional<char> endMark() const { return end_mark_; }
    /// What came of the present block, all of it handed out.
    [[nodiscard]] const std::string& block() const { return block_; }
    /// The line was silent or begins anew: what comes next is another block.
    void breakOff();

private:
    void put(char byte, std::vector<Piece>& pieces);
    [[nodiscard]] bool mayBecomeStream() const;

    std::string stream_head_;
    std::optional<char> end_mark_ = '>';
    std::string block_;
    std::string held_;  ///< at the head of a block, not handed out yet
    bool inside_ = false;
    bool streams_ = false;
};

}  // namespace pmts::scheduler
