#include "character_decoder.hpp"
#include "line_runs.hpp"
#include "pmts/protocol/line_decoding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pmts::protocol {
namespace {

constexpr std::array kUsualBauds{300.0,   600.0,   1200.0,  2400.0,  4800.0,   9600.0,  14400.0,
                                 19200.0, 31250.0, 38400.0, 57600.0, 115200.0, 230400.0};
constexpr double kSamePace = 0.02;      ///< two paces this near are one
constexpr std::size_t kMostPaces = 24;
constexpr std::size_t kMostRefined = 24;
constexpr std::size_t kMostFound = 8;
constexpr std::size_t kSearchRuns = 4000;  ///< enough for a coarse score
constexpr std::size_t kLeastCharacters = 4;
constexpr double kUsualUnitShare = 0.1;

using Lengths = std::map<std::uint64_t, std::size_t>;

Lengths lengthsOf(const LineRuns& runs) {
    Lengths lengths;
    for (std::size_t i = 1; i + 1 < runs.size(); ++i) {
        ++lengths[runs.length(i)];
    }
    return lengths;
}

void addPace(std::vector<double>& paces, double pace) {
    const auto same = [pace](double known) { return std::abs(known - pace) <= kSamePace * pace; };
    if (pace >= 1.0 && paces.size() < kMostPaces && std::ranges::none_of(paces, same)) {
        paces.push_back(pace);
    }
}

/// Weighted mean of a peak of the histogram: an eighth to each side.
double peakMean(const Lengths& lengths, std::uint64_t at) {
    double sum = 0.0, weight = 0.0;
    const std::uint64_t reach = at / 8;
    for (auto near = lengths.lower_bound(at - reach); near != lengths.end() && near->first <= at + reach; ++near) {
        sum += static_cast<double>(near->first * near->second);
        weight += static_cast<double>(near->second);
    }
    return sum / weight;
}

/// Lengths a bit may have: the usual bauds when the sample rate is known, and the most frequent run lengths with
/// their parts.
std::vector<double> pacesOf(const LineRuns& runs, std::optional<double> samples_per_s) {
    std::vector<double> paces;
    const Lengths lengths = lengthsOf(runs);
    std::vector<std::pair<std::size_t, std::uint64_t>> frequent;
    for (const auto& [length, times] : lengths) {
        frequent.emplace_back(times, length);
    }
    std::ranges::sort(frequent, std::greater<>());
    for (std::size_t i = 0; i < std::min<std::size_t>(frequent.size(), 6); ++i) {
        const double mean = peakMean(lengths, frequent[i].second);
        for (const double part : {1.0, 2.0, 3.0}) {
            addPace(paces, mean / part);
        }
    }
    for (const double baud : kUsualBauds) {
        if (samples_per_s) {
            addPace(paces, *samples_per_s / baud);
        }
    }
    return paces;
}

bool isUsualText(unsigned char c) {
    return (c >= 0x20 && c < 0x7F) || c == '\r' || c == '\n' || c == '\t' || c == 0x02 || c == 0x03 || c == 0x04;
}

/// How much of the pauses the line spends at the framing's level of rest; 0.5 without pauses.
double restShare(const LineRuns& runs, const Framing& framing) {
    const LineRuns calm = withoutGlitches(runs, 0.2 * framing.samples_per_bit);
    double rest = 1.0, all = 2.0;
    for (std::size_t i = 0; i < calm.size(); ++i) {
        const auto length = static_cast<double>(calm.length(i));
        if (length > 10.5 * framing.samples_per_bit) {
            all += length;
            rest += calm.isHigh(i) == framing.idle_high ? length : 0.0;
        }
    }
    return rest / all;
}

/// Share of the time between pauses that the line spends in stretches of one bit. Text has a tenth and more at its true
/// pace; at half of it, or at the pace of glitches, next to nothing.
double unitShare(const LineRuns& runs, double pace) {
    double unit = 0.0, active = 0.0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto length = static_cast<double>(runs.length(i));
        active += length <= 12.0 * pace ? length : 0.0;
        unit += length >= 0.6 * pace && length <= 1.5 * pace ? length : 0.0;
    }
    return active > 0.0 ? unit / active : 0.0;
}

/// Characters that are sure count, more when they are text and when all their samples agree.
FramingScore scoreOf(const LineRuns& runs, const Framing& framing) {
    const auto characters = CharacterDecoder(runs, framing).all();
    FramingScore score{.framing = framing, .characters = characters.size()};
    if (characters.size() < kLeastCharacters) {
        return score;
    }
    const auto n = static_cast<double>(characters.size());
    const double sure = static_cast<double>(std::ranges::count_if(characters, &DecodedCharacter::isSure)) / n;
    const double text = static_cast<double>(std::ranges::count_if(
                            characters, [](const auto& c) { return isUsualText(c.value); })) / n;
    double margin = 0.0;
    for (const DecodedCharacter& character : characters) {
        margin += character.margin / n;
    }
    const double parity = framing.parity == LineParity::kNone ? 0.0 : 0.02;  // a parity that always holds is no chance
    const double paced = std::min(1.0, unitShare(runs, framing.samples_per_bit) / kUsualUnitShare);
    const double rested = 0.5 + 0.5 * restShare(runs, framing);
    score.score = std::min(1.0, rested * paced * sure * (0.4 + 0.4 * text + 0.2 * margin) * (0.98 + parity));
    return score;
}

std::vector<Framing> formsAt(int line, double pace) {
    std::vector<Framing> forms;
    for (const bool idle_high : {true, false}) {
        for (const int data_bits : {8, 7}) {
            for (const LineParity parity : {LineParity::kNone, LineParity::kEven, LineParity::kOdd}) {
                for (const bool least_first : {true, false}) {
                    forms.push_back({.line = line,
                                     .samples_per_bit = pace,
                                     .idle_high = idle_high,
                                     .data_bits = data_bits,
                                     .parity = parity,
                                     .least_significant_first = least_first});
                }
            }
        }
    }
    return forms;
}

/// The pace around a good one at which the bits are surest.
FramingScore refined(const LineRuns& runs, FramingScore best) {
    for (const double step : {0.012, 0.004, 0.0015}) {
        const double centre = best.framing.samples_per_bit;
        for (int i = -3; i <= 3; ++i) {
            Framing framing = best.framing;
            framing.samples_per_bit = centre * (1.0 + i * step);
            const FramingScore tried = scoreOf(runs, framing);
            if (framing.samples_per_bit >= 1.0 && tried.score > best.score + 1e-9) {
                best = tried;
            }
        }
    }
    return best;
}

}  // namespace

std::vector<FramingScore> findFraming(const LineCapture& capture, int line, std::size_t most_runs) {
    const LineRuns runs = runsOf(capture, line, most_runs);
    if (runs.size() < 2 * kLeastCharacters) {
        return {};
    }
    const LineRuns first = runsOf(capture, line, std::min(most_runs, kSearchRuns));
    std::vector<FramingScore> found;
    for (const double pace : pacesOf(runs, capture.samples_per_s)) {
        for (const Framing& framing : formsAt(line, pace)) {
            if (const FramingScore score = scoreOf(first, framing); score.score > 0.0) {
                found.push_back(score);
            }
        }
    }
    std::ranges::stable_sort(found, std::greater<>(), &FramingScore::score);
    found.resize(std::min(found.size(), kMostRefined));
    for (FramingScore& score : found) {
        score = refined(first, score);
    }
    std::ranges::stable_sort(found, std::greater<>(), &FramingScore::score);
    found.resize(std::min(found.size(), kMostFound));
    for (FramingScore& score : found) {
        score = scoreOf(runs, score.framing);
        score.baud = capture.samples_per_s ? *capture.samples_per_s / score.framing.samples_per_bit : 0.0;
    }
    std::ranges::stable_sort(found, std::greater<>(), &FramingScore::score);
    return found;
}

}  // namespace pmts::protocol
