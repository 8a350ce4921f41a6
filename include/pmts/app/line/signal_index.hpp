#pragma once

#include "pmts/protocol/line_capture.hpp"

#include <cstdint>
#include <vector>

namespace pmts::app {

/// Finds what the lines of a capture did between two samples, whatever their number: blocks of runs are summed up once,
/// so that a picture of 10^7 changes looks at some thousand of them. The capture outlives it.
class SignalIndex {
public:
    /// Lines that were low, and lines that were high, at some time.
    struct Levels {
        std::uint32_t low = 0, high = 0;
    };

    explicit SignalIndex(const protocol::LineCapture& capture);

    [[nodiscard]] std::uint64_t samples() const { return samples_; }
    [[nodiscard]] Levels between(std::uint64_t from, std::uint64_t to) const;

private:
    static constexpr std::size_t kBlock = 256;

    struct Block {
        std::uint64_t begin = 0;
        Levels levels;
    };

    const protocol::LineCapture& capture_;
    std::vector<Block> blocks_;
    std::uint64_t samples_ = 0;
};

}  // namespace pmts::app
