#pragma once

#include "pmts/protocol/line_capture.hpp"

namespace pmts::protocol {

/// One line of a capture by itself, or a piece of it: alternating stretches of low and high.
struct LineRuns {
    bool first_high = false;
    std::vector<std::uint64_t> begins;  ///< sample of the capture at which each stretch begins
    std::uint64_t end = 0;              ///< sample behind the last stretch

    [[nodiscard]] std::size_t size() const { return begins.size(); }
    [[nodiscard]] bool isHigh(std::size_t run) const { return (run % 2 == 0) == first_high; }
    [[nodiscard]] std::uint64_t endOf(std::size_t run) const { return run + 1 < size() ? begins[run + 1] : end; }
    [[nodiscard]] std::uint64_t length(std::size_t run) const { return endOf(run) - begins[run]; }
};

/// Hands out one line of a capture in pieces, so that a long one never lies in memory twice.
class LinePieces {
public:
    LinePieces(const LineCapture& capture, int line) : capture_(capture), mask_(1U << line) {}

    [[nodiscard]] bool isAtEnd() const { return run_ == capture_.runs.size(); }
    [[nodiscard]] LineRuns take(std::size_t most_runs);
    /// The next piece begins again at a stretch of the last one.
    void goBackTo(std::uint64_t sample);
    [[nodiscard]] double doneShare() const;

private:
    const LineCapture& capture_;
    std::uint32_t mask_;
    std::size_t run_ = 0, piece_run_ = 0;
    std::uint64_t sample_ = 0, piece_sample_ = 0;
};

/// The first `most_runs` stretches of the line.
[[nodiscard]] LineRuns runsOf(const LineCapture& capture, int line, std::size_t most_runs = SIZE_MAX);
/// Stretches shorter than `shortest` samples joined to the one before them.
[[nodiscard]] LineRuns withoutGlitches(const LineRuns& runs, double shortest);

}  // namespace pmts::protocol
