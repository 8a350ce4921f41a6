#include "line_runs.hpp"

namespace pmts::protocol {

LineRuns LinePieces::take(std::size_t most_runs) {
    piece_run_ = run_;
    piece_sample_ = sample_;
    LineRuns runs{.first_high = !isAtEnd() && (capture_.runs[run_].levels & mask_) != 0, .begins = {}, .end = sample_};
    bool high = !runs.first_high;
    for (; run_ < capture_.runs.size(); ++run_) {
        const bool is_high = (capture_.runs[run_].levels & mask_) != 0;
        if (is_high != high) {
            if (runs.size() == most_runs) {
                break;
            }
            runs.begins.push_back(runs.end);
            high = is_high;
        }
        runs.end += capture_.runs[run_].samples;
    }
    sample_ = runs.end;
    return runs;
}

void LinePieces::goBackTo(std::uint64_t sample) {
    run_ = piece_run_;
    sample_ = piece_sample_;
    while (sample_ < sample) {
        sample_ += capture_.runs[run_++].samples;
    }
}

double LinePieces::doneShare() const {
    return isAtEnd() ? 1.0 : static_cast<double>(run_) / static_cast<double>(capture_.runs.size());
}

LineRuns runsOf(const LineCapture& capture, int line, std::size_t most_runs) {
    return LinePieces(capture, line).take(most_runs);
}

LineRuns withoutGlitches(const LineRuns& runs, double shortest) {
    LineRuns calm{.first_high = runs.first_high, .begins = {}, .end = runs.end};
    bool high = false;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const bool glitch = static_cast<double>(runs.length(i)) < shortest;
        if (calm.begins.empty() || (runs.isHigh(i) != high && !glitch)) {
            calm.begins.push_back(runs.begins[i]);
            high = runs.isHigh(i);
        }
    }
    return calm;
}

}  // namespace pmts::protocol
