#include "block_watch.hpp"

namespace pmts::scheduler {
namespace {

/// A block without end is noise: only its last part is of use.
constexpr std::size_t kLongestBlock = std::size_t{1} << 16;

}  // namespace

std::vector<BlockWatch::Piece> BlockWatch::feed(std::string_view bytes) {
    std::vector<Piece> pieces;
    for (const char byte : bytes) {
        put(byte, pieces);
    }
    return pieces;
}

void BlockWatch::put(char byte, std::vector<Piece>& pieces) {
    block_ += byte;
    held_ += byte;
    const bool ends = end_mark_ == byte;
    if (!inside_ && !ends && mayBecomeStream()) {
        return;
    }
    if (!inside_) {
        streams_ = !stream_head_.empty() && block_.starts_with(stream_head_);
    }
    const bool begins = !std::exchange(inside_, true);
    if (begins || pieces.empty() || pieces.back().ends) {
        pieces.push_back({.bytes = {}, .begins = begins, .ends = ends, .streams = streams_});
    }
    pieces.back().bytes += std::exchange(held_, {});
    pieces.back().ends = ends;
    if (ends) {
        block_.pop_back();
        pieces.back().block = std::exchange(block_, {});
        inside_ = false;
    } else if (block_.size() > kLongestBlock) {
        block_.erase(0, kLongestBlock / 2);
    }
}

bool BlockWatch::mayBecomeStream() const {
    return block_.size() < stream_head_.size() && stream_head_.starts_with(block_);
}

void BlockWatch::breakOff() {
    block_ = held_;
    inside_ = false;
}

}  // namespace pmts::scheduler
