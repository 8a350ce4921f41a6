#pragma once

#include "pmts/protocol/line_capture.hpp"

#include <span>
#include <string>

namespace pmts::protocol {

/// How a line of a capture moves (thesis 3.5.3: constant pins feed, rarely moving ones switch, the others carry data).
enum class LineUse { kConstant, kSwitching, kData };

struct LineActivity {
    int line = 0;
    LineUse use = LineUse::kConstant;
    std::uint64_t changes = 0;
    double high_share = 0.0;  ///< of the time, 0 to 1
};

/// Each line by itself. A line that carries data has more than 20 changes and, between its pauses, at least one in 20 of
/// its shortest runs.
[[nodiscard]] std::vector<LineActivity> lineActivities(const LineCapture& capture);

/// The thesis's rule: three or more data lines that move in step make a parallel port, fewer a serial one.
enum class PortKind { kNone, kSerial, kParallel };
[[nodiscard]] PortKind portKind(const std::vector<LineActivity>& lines);

/// How many samples stand for one bit, to a sample: the shortest run, when nine in ten of the runs are multiples of it.
/// Noise makes it 1.
[[nodiscard]] std::optional<std::uint32_t> repeatCount(const LineCapture& capture);
/// Every run divided by the repeat count: a capture of one sample for each bit.
[[nodiscard]] std::optional<LineCapture> dereplicated(const LineCapture& capture);

enum class LineParity { kNone, kEven, kOdd };

/// Asynchronous framing of one line.
struct Framing {
    int line = 0;
    double samples_per_bit = 1.0;
    bool idle_high = true;
    int data_bits = 8;
    LineParity parity = LineParity::kNone;
    bool least_significant_first = true;

    /// `8N1`, `7E1`.
    [[nodiscard]] QString text() const;
};

/// Which way a character went, where that is known.
enum class TalkSide : unsigned char { kUnknown, kToInstrument, kFromInstrument };

/// One character as it came over the line. Sixteen bytes, because long captures have millions.
struct DecodedCharacter {
    unsigned char value = 0;
    bool framing_error = false;
    bool parity_error = false;
    TalkSide side = TalkSide::kUnknown;
    float margin = 1.0F;       ///< of the least certain bit: 1 all samples agree, 0 half of them
    std::uint64_t sample = 0;  ///< where its start bit begins

    /// Below this margin a bit may as well be the other one: a quarter of its samples disagree.
    static constexpr float kSureMargin = 0.5F;
    [[nodiscard]] bool isSure() const { return !framing_error && !parity_error && margin >= kSureMargin; }
};

/// 8N1 and its kin (EIA-404 framing): idle, start bit, data bits, parity bit, stop bit. Each bit is the majority of the
/// samples in its middle 70 %, so that single wrong samples do no harm; a start bit without a majority is a glitch.
/// After a framing error the search goes on at the next edge. Works in pieces, so that memory is what the capture and the
/// characters take.
[[nodiscard]] std::vector<DecodedCharacter> decodeLine(const LineCapture& capture, const Framing& framing,
                                                       const Progress& progress = {});

/// A framing and how well it explains the line.
struct FramingScore {
    Framing framing;
    double score = 0.0;  ///< 0 to 1: characters that are sure, and text
    double baud = 0.0;   ///< 0 when the sample rate is not known
    std::size_t characters = 0;
};

/// Finds baud, polarity, data bits, parity and bit order of a line, best first, at most eight; empty for a
/// line that carries nothing. Looks at the first `most_runs` runs.
[[nodiscard]] std::vector<FramingScore> findFraming(const LineCapture& capture, int line, std::size_t most_runs = 40'000);

/// Printable text with `<CR>`, `<EOT>` and `<hh>` for the rest; characters that are not sure stand in `[?..]`.
[[nodiscard]] std::string textOf(std::span<const DecodedCharacter> characters);

}  // namespace pmts::protocol
