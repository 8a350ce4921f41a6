#pragma once

#include "pmts/protocol/line_capture.hpp"

namespace pmts::protocol {

/// One line of a capture by itself: alternating stretches of low and high.
struct LineRuns {
    bool first_high = false;
    std::vector<std::uint64_t> begins;  ///< sample at which each stretch begins; the first is 0
    std::uint64_t end = 0;              ///< samples in all

    [[nodiscard]] std::size_t size() const { return begins.size(); }
    [[nodiscard]] bool isHigh(std::size_t run) const { return (run % 2 == 0) == first_high; }
    [[nodiscard]] std::uint64_t endOf(std::size_t run) const { return run + 1 < size() ? begins[run + 1] : end; }
    [[nodiscard]] std::uint64_t length(std::size_t run) const { return endOf(run) - begins[run]; }
};

/// The first `most_runs` stretches of the line.
[[nodiscard]] LineRuns runsOf(const LineCapture& capture, int line, std::size_t most_runs = SIZE_MAX);
/// Stretches shorter than `shortest` samples joined to the one before them.
[[nodiscard]] LineRuns withoutGlitches(const LineRuns& runs, double shortest);

}  // namespace pmts::protocol
