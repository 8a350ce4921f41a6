#include "line_runs.hpp"

namespace pmts::protocol {

LineRuns runsOf(const LineCapture& capture, int line, std::size_t most_runs) {
    LineRuns runs;
    const std::uint32_t mask = 1U << line;
    bool high = false;
    for (const LevelRun& run : capture.runs) {
        const bool is_high = (run.levels & mask) != 0;
        if (runs.begins.empty()) {
            runs.first_high = is_high;
            runs.begins.push_back(0);
        } else if (is_high != high) {
            if (runs.size() == most_runs) {
                break;
            }
            runs.begins.push_back(runs.end);
        }
        high = is_high;
        runs.end += run.samples;
    }
    return runs;
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
