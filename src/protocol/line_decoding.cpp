#include "pmts/protocol/line_decoding.hpp"

#include "character_decoder.hpp"
#include "line_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::protocol {
namespace {

constexpr std::uint64_t kBusyChanges = 20;
constexpr double kPauseOverRun = 20.0;  ///< a stretch this many times the usual one is a pause
constexpr int kParallelLines = 3;

/// Length of the usual stretch: the lower quartile, deaf to pauses and not too fond of glitches.
double usualRun(const LineRuns& runs) {
    std::vector<std::uint64_t> lengths;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        lengths.push_back(runs.length(i));
    }
    const auto quartile = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 4);
    std::ranges::nth_element(lengths, quartile);
    return static_cast<double>(*quartile);
}

LineActivity activityOf(const LineCapture& capture, int line) {
    const LineRuns runs = runsOf(capture, line);
    LineActivity activity{.line = line, .changes = runs.size() == 0 ? 0 : runs.size() - 1};
    std::uint64_t high = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        high += runs.isHigh(i) ? runs.length(i) : 0;
    }
    activity.high_share = runs.end == 0 ? 0.0 : static_cast<double>(high) / static_cast<double>(runs.end);
    if (activity.changes == 0) {
        return activity;
    }
    const double usual = usualRun(runs);
    std::size_t short_runs = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        short_runs += static_cast<double>(runs.length(i)) <= kPauseOverRun * usual ? 1U : 0U;
    }
    const bool dense = 2 * short_runs > runs.size();
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
    for (int line = 0; line < capture.lines; ++line) {
        activities.push_back(activityOf(capture, line));
    }
    return activities;
}

PortKind portKind(const std::vector<LineActivity>& lines) {
    const auto busy = std::ranges::count(lines, LineUse::kData, &LineActivity::use);
    return busy == 0 ? PortKind::kNone : busy < kParallelLines ? PortKind::kSerial : PortKind::kParallel;
}

std::optional<LineCapture> dereplicated(const LineCapture& capture) {
    if (capture.runs.size() < 2) {
        return std::nullopt;
    }
    std::uint64_t shortest = capture.runs.front().samples;
    for (const LevelRun& run : capture.runs) {
        shortest = std::min(shortest, run.samples);
    }
    const auto unit = static_cast<double>(shortest);
    if (wholeShare(capture.runs, unit) < 0.9) {
        return std::nullopt;
    }
    LineCapture bits = capture;
    bits.runs.clear();
    bits.samples_per_s = capture.samples_per_s ? std::optional(*capture.samples_per_s / unit) : std::nullopt;
    for (const LevelRun& run : capture.runs) {
        const auto times = static_cast<std::uint64_t>(std::llround(static_cast<double>(run.samples) / unit));
        bits.append(run.levels, std::max<std::uint64_t>(1, times));
    }
    return bits;
}

QString Framing::text() const {
    constexpr std::array kParity{'N', 'E', 'O'};
    return QStringLiteral("%1%2%3").arg(data_bits).arg(QLatin1Char(kParity[static_cast<std::size_t>(parity)])).arg(1);
}

std::vector<DecodedCharacter> decodeLine(const LineCapture& capture, const Framing& framing) {
    const LineRuns runs = runsOf(capture, framing.line);
    return CharacterDecoder(runs, framing).all();
}

std::string textOf(const std::vector<DecodedCharacter>& characters) {
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string text;
    for (const DecodedCharacter& character : characters) {
        std::string shown;
        switch (character.value) {
            case '\r':
                shown = "<CR>";
                break;
            case '\n':
                shown = "<LF>";
                break;
            case 0x04:
                shown = "<EOT>";
                break;
            default:
                shown = character.value >= 0x20 && character.value < 0x7F
                            ? std::string(1, static_cast<char>(character.value))
                            : std::string{'<', kDigits[character.value >> 4], kDigits[character.value & 15], '>'};
        }
        text += character.isSure() ? shown : "[?" + shown + "]";
    }
    return text;
}

}  // namespace pmts::protocol
