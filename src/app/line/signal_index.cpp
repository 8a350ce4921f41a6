#include "pmts/app/line/signal_index.hpp"

#include <algorithm>

namespace pmts::app {
namespace {

void add(SignalIndex::Levels& sum, std::uint32_t levels) {
    sum.high |= levels;
    sum.low |= ~levels;
}

}  // namespace

SignalIndex::SignalIndex(const protocol::LineCapture& capture) : capture_(capture) {
    blocks_.reserve(capture.runs.size() / kBlock + 1);
    for (std::size_t run = 0; run < capture.runs.size(); ++run) {
        if (run % kBlock == 0) {
            blocks_.push_back({.begin = samples_, .levels = {}});
        }
        add(blocks_.back().levels, capture.runs[run].levels);
        samples_ += capture.runs[run].samples;
    }
}

SignalIndex::Levels SignalIndex::between(std::uint64_t from, std::uint64_t to) const {
    Levels sum;
    to = std::min(to, samples_);
    if (from >= to) {
        return sum;
    }
    const auto behind = std::ranges::upper_bound(blocks_, from, {}, &Block::begin);
    auto block = static_cast<std::size_t>(behind - blocks_.begin()) - 1;
    std::uint64_t at = blocks_[block].begin;
    while (block < blocks_.size() && at < to) {
        const std::uint64_t block_end = block + 1 < blocks_.size() ? blocks_[block + 1].begin : samples_;
        if (at >= from && block_end <= to) {
            sum.low |= blocks_[block].levels.low;
            sum.high |= blocks_[block].levels.high;
        } else {
            const std::size_t end = std::min((block + 1) * kBlock, capture_.runs.size());
            std::uint64_t begin = at;
            for (std::size_t run = block * kBlock; run < end && begin < to; ++run) {
                const std::uint64_t run_end = begin + capture_.runs[run].samples;
                if (run_end > from) {
                    add(sum, capture_.runs[run].levels);
                }
                begin = run_end;
            }
        }
        at = block_end;
        ++block;
    }
    return sum;
}

}  // namespace pmts::app
