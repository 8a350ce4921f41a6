#include "pmts/protocol/line_decoding.hpp"

#include "character_decoder.hpp"
#include "line_runs.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace pmts::protocol {
namespace {

constexpr std::uint64_t kBusyChanges = 20;
constexpr double kPauseOverRun = 20.0;  ///< a stretch this many times the usual one is a pause
constexpr int kParallelLines = 3;
constexpr std::size_t kPieceRuns = 1U << 16;  ///< of a line, in memory at a time

/// Lengths of stretches, counted: exact below 1024, to 3 % above.
class LengthCounts {
public:
    void add(std::uint64_t length) {
        ++times_[bucketOf(length)];
        ++all_;
    }
    [[nodiscard]] std::uint64_t count() const { return all_; }
    /// The lower quartile: deaf to pauses and not too fond of glitches.
    [[nodiscard]] double usual() const {
        std::uint64_t before = 0;
        for (std::size_t i = 0; i < times_.size(); ++i) {
            before += times_[i];
            if (before > all_ / 4) {
                return lengthOf(i);
            }
        }
        return 0.0;
    }
    [[nodiscard]] std::uint64_t upTo(double length) const {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < times_.size() && lengthOf(i) <= length; ++i) {
            sum += times_[i];
        }
        return sum;
    }

private:
    static constexpr std::size_t kExact = 1024, kParts = 32, kOctaves = 54;

    static std::size_t bucketOf(std::uint64_t length) {
        if (length < kExact) {
            return static_cast<std::size_t>(length);
        }
        const auto octave = static_cast<std::size_t>(std::bit_width(length)) - 11;
        return kExact + kParts * octave + static_cast<std::size_t>((length >> (octave + 5)) - kParts);
    }
    static double lengthOf(std::size_t bucket) {
        if (bucket < kExact) {
            return static_cast<double>(bucket);
        }
        const std::size_t octave = (bucket - kExact) / kParts;
        return std::ldexp(static_cast<double>(kParts + (bucket - kExact) % kParts), static_cast<int>(octave) + 5);
    }

    std::vector<std::uint64_t> times_ = std::vector<std::uint64_t>(kExact + kParts * kOctaves);
    std::uint64_t all_ = 0;
};

/// What one line did, gathered in one walk along all of them.
struct LineCount {
    LengthCounts lengths;
    std::uint64_t since = 0, high = 0;

    void end(std::uint64_t sample, bool was_high) {
        lengths.add(sample - since);
        high += was_high ? sample - since : 0;
        since = sample;
    }
};

std::vector<LineCount> countedLines(const LineCapture& capture, std::uint64_t& samples) {
    std::vector<LineCount> lines(static_cast<std::size_t>(capture.lines));
    std::uint32_t before = capture.runs.empty() ? 0 : capture.runs.front().levels;
    for (const LevelRun& run : capture.runs) {
        for (std::uint32_t moved = run.levels ^ before; moved != 0; moved &= moved - 1) {
            const auto line = static_cast<std::size_t>(std::countr_zero(moved));
            if (line < lines.size()) {
                lines[line].end(samples, (before >> line & 1U) != 0);
            }
        }
        before = run.levels;
        samples += run.samples;
    }
    for (std::size_t line = 0; line < lines.size() && samples > 0; ++line) {
        lines[line].end(samples, (before >> line & 1U) != 0);
    }
    return lines;
}

LineActivity activityOf(int line, const LineCount& count, std::uint64_t samples) {
    LineActivity activity{.line = line, .changes = count.lengths.count() == 0 ? 0 : count.lengths.count() - 1};
    activity.high_share = samples == 0 ? 0.0 : static_cast<double>(count.high) / static_cast<double>(samples);
    if (activity.changes == 0) {
        return activity;
    }
    const bool dense = 2 * count.lengths.upTo(kPauseOverRun * count.lengths.usual()) > count.lengths.count();
    activity.use = activity.changes > kBusyChanges && dense ? LineUse::kData : LineUse::kSwitching;
    return activity;
}

/// Share of the runs that are a whole multiple of `unit`, within a quarter of it or a sample.
double wholeShare(const std::vector<LevelRun>& runs, double unit) {
    std::size_t whole = 0;
    for (const LevelRun& run : runs) {
        const double times = static_cast<double>(run.samples) / unit;
        const double off = std::abs(times - std::round(times));
        whole += times >= 0.75 && (off <= 0.25 || off * unit <= 1.0 || times > 10.0) ? 1U : 0U;
    }
    return static_cast<double>(whole) / static_cast<double>(runs.size());
}

}  // namespace

std::vector<LineActivity> lineActivities(const LineCapture& capture) {
    std::vector<LineActivity> activities;
    std::uint64_t samples = 0;
    const std::vector<LineCount> counts = countedLines(capture, samples);
    for (int line = 0; line < capture.lines; ++line) {
        activities.push_back(activityOf(line, counts[static_cast<std::size_t>(line)], samples));
    }
    return activities;
}

PortKind portKind(const std::vector<LineActivity>& lines) {
    const auto busy = std::ranges::count(lines, LineUse::kData, &LineActivity::use);
    return busy == 0 ? PortKind::kNone : busy < kParallelLines ? PortKind::kSerial : PortKind::kParallel;
}

std::optional<std::uint32_t> repeatCount(const LineCapture& capture) {
    if (capture.runs.size() < 2) {
        return std::nullopt;
    }
    const std::uint32_t shortest = std::ranges::min_element(capture.runs, {}, &LevelRun::samples)->samples;
    return wholeShare(capture.runs, shortest) < 0.9 ? std::nullopt : std::optional(shortest);
}

std::optional<LineCapture> dereplicated(const LineCapture& capture) {
    const auto repeats = repeatCount(capture);
    if (!repeats) {
        return std::nullopt;
    }
    const double unit = *repeats;
    LineCapture bits;
    bits.lines = capture.lines;
    bits.names = capture.names;
    bits.samples_per_s = capture.samples_per_s ? std::optional(*capture.samples_per_s / unit) : std::nullopt;
    bits.runs.reserve(capture.runs.size());
    for (const LevelRun& run : capture.runs) {
        const auto times = static_cast<std::uint64_t>(std::llround(run.samples / unit));
        bits.append(run.levels, std::max<std::uint64_t>(1, times));
    }
    return bits;
}

QString Framing::text() const {
    constexpr std::array kParity{'N', 'E', 'O'};
    return QStringLiteral("%1%2%3").arg(data_bits).arg(QLatin1Char(kParity[static_cast<std::size_t>(parity)])).arg(1);
}

std::vector<DecodedCharacter> decodeLine(const LineCapture& capture, const Framing& framing, const Progress& progress) {
    std::vector<DecodedCharacter> characters;
    LinePieces pieces(capture, framing.line);
    while (!pieces.isAtEnd() && (!progress || progress(pieces.doneShare()))) {
        const LineRuns piece = pieces.take(kPieceRuns);
        CharacterDecoder decoder(piece, framing);
        if (pieces.isAtEnd()) {
            const auto last = decoder.all();
            characters.insert(characters.end(), last.begin(), last.end());
            break;
        }
        const std::uint64_t rest = decoder.readOn(characters);
        if (rest > piece.begins.front()) {
            pieces.goBackTo(rest);
        }
    }
    return characters;
}

}  // namespace pmts::protocol
