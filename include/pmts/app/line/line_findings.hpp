#pragma once

#include "pmts/app/line/line_recording.hpp"
#include "pmts/app/line/signal_index.hpp"
#include "pmts/protocol/line_talk.hpp"
#include "pmts/protocol/panel_correlation.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pmts::app {

/// What a person says about a line against what was found.
struct LineChoice {
    std::optional<bool> is_decoded;
    std::optional<protocol::Framing> framing;
    std::optional<protocol::TalkSide> side;
};
using LineChoices = std::map<int, LineChoice>;

/// One line of a recording.
struct FoundLine {
    protocol::LineActivity activity;
    std::vector<protocol::FramingScore> scores;  ///< best first; empty when it was not searched or says nothing
    bool is_decoded = false;
    std::optional<protocol::Framing> framing;    ///< the one in use
    protocol::TalkSide side = protocol::TalkSide::kUnknown;
    std::size_t characters = 0, unsure = 0;

    /// Of the framing in use; absent when it was given by hand.
    [[nodiscard]] std::optional<double> score() const;
};

/// A variable of the stream: how often it was said, and its last value.
struct SeenVariable {
    char unit = 'A';
    int variable = 0;
    std::size_t times = 0;
    double last = 0.0;
};

/// Everything the bench for unknown lines knows of a recording.
struct LineFindings {
    std::shared_ptr<const LineRecording> recording;
    std::shared_ptr<const SignalIndex> signal;  ///< null without levels
    std::vector<FoundLine> lines;
    protocol::PortKind port = protocol::PortKind::kNone;
    std::optional<std::uint32_t> repeats;  ///< samples for each bit, when the runs are multiples of it
    std::vector<protocol::DecodedCharacter> characters;
    std::vector<protocol::TalkLine> talk;
    std::string bytes;        ///< of the characters, to search in
    std::string doubt_marks;  ///< `?` for each character that is not sure, a blank for the others
    std::vector<protocol::StreamValue> values;
    std::vector<SeenVariable> variables;  ///< of the values, each once
    std::size_t unsure = 0;

    [[nodiscard]] std::uint64_t samples() const;  ///< from the first to the last
    /// `9600` of a framing; absent when the sample rate is not known.
    [[nodiscard]] std::optional<double> baudOf(const protocol::Framing& framing) const;
};

/// Pins, port, framings by score; nothing is decoded yet. kCancelled when `progress` says false.
[[nodiscard]] core::Result<LineFindings> examined(LineRecording recording, const protocol::Progress& progress = {});
/// Decodes what carries data (all lines of a serial port, the busiest of a parallel one), or what was chosen.
/// kUndefined when nothing can be decoded.
[[nodiscard]] core::Result<LineFindings> decoded(LineFindings findings, const LineChoices& choices,
                                                 const protocol::Progress& progress = {});
/// The line that is decoded first: it carries data and changes most; absent when none moves.
[[nodiscard]] std::optional<int> busiestLine(const LineFindings& findings);

/// Words for a framing: `8N1, least significant bit first, rests high`.
[[nodiscard]] QString framingWords(const protocol::Framing& framing);

}  // namespace pmts::app
