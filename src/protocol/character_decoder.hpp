#pragma once

#include "line_runs.hpp"
#include "pmts/protocol/line_decoding.hpp"

namespace pmts::protocol {

/// Walks along one line and reads its characters: start bits begin where the line changes for more than a fifth of a bit,
/// each bit is the majority of its samples.
class CharacterDecoder {
public:
    CharacterDecoder(const LineRuns& runs, const Framing& framing);

    [[nodiscard]] std::vector<DecodedCharacter> all();
    /// Appends what ends within the runs, as long as the line goes on behind them; the sample at which to begin again.
    std::uint64_t readOn(std::vector<DecodedCharacter>& characters);

private:
    struct Bit {
        bool high = false;
        double margin = 0.0;
    };

    [[nodiscard]] bool toNextEdge();
    [[nodiscard]] Bit bitAt(double begin) const;
    [[nodiscard]] double highTime(double from, double to) const;
    [[nodiscard]] DecodedCharacter read(double begin) const;
    void goOnAfter(double sample);
    void readTo(double last_begin, std::vector<DecodedCharacter>& characters);

    const LineRuns& runs_;
    const Framing framing_;
    const LineRuns edges_;    ///< without glitches
    std::size_t edge_ = 0;    ///< stretch of edges_ the walk is in
    std::size_t run_ = 0;     ///< stretch of runs_ that bits are counted from
};

}  // namespace pmts::protocol
