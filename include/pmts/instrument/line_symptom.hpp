#pragma once

#include "pmts/transport/serial_link.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace pmts::instrument {

/// What a line shows after a question, the most telling last.
enum class LineSymptom {
    kSilent,       ///< no byte: cable, switched off, wrong wires, wrong port
    kEcho,         ///< only what was sent: the cable loops back
    kGarbled,      ///< bytes, but no text: speed or framing differ
    kOtherDevice,  ///< text that is not the instrument's grammar
    kModem,        ///< it answers as modems do
    kBusStream,    ///< the angle stream of the bus under the panel
    kUnasked,      ///< the grammar, but not the answer: the instrument sends by itself
    kAnswer,       ///< the instrument
};

struct LineEvidence {
    LineSymptom symptom = LineSymptom::kSilent;
    bool echoes = false;                ///< what was sent came back before anything else
    std::optional<int> label_79;        ///< as the instrument gave it
    std::optional<char> end_mark;       ///< the byte behind the last line; absent: none came
    /// The bytes are text with a parity bit on top of seven: that is how the other side talks.
    std::optional<transport::Parity> seven_bits_with;

    [[nodiscard]] bool isInstrument() const { return symptom == LineSymptom::kAnswer || symptom == LineSymptom::kUnasked; }
    /// PMTS can be connected here: to the external interface, or to the bus.
    [[nodiscard]] bool isOurs() const { return isInstrument() || symptom == LineSymptom::kBusStream; }
    [[nodiscard]] bool operator==(const LineEvidence&) const = default;
};

/// Judges what was heard after the question `RG,79` was sent (protocol page 1.3; the bus: 5.2). Pure, no line.
[[nodiscard]] LineEvidence judgeLine(std::string_view sent, std::string_view heard);

}  // namespace pmts::instrument
