#include "pmts/protocol/line_capture.hpp"

#include "watch.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <numeric>

namespace pmts::protocol {
namespace {

/// Sample number `at`; sigrok's order is the lowest byte first.
template <std::size_t kSize>
std::uint32_t sampleAt(const char* bytes, std::size_t at) {
    std::uint32_t levels = 0;
    for (std::size_t i = 0; i < kSize; ++i) {
        levels |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[kSize * at + i])) << (8 * i);
    }
    return levels;
}

template <std::size_t kSize>
void appendSamples(LineCapture& capture, std::string_view bytes, Watch& watch) {
    const std::size_t count = bytes.size() / kSize;
    if (count == 0) {
        return;
    }
    std::size_t changes = 1;
    watch.setStage(0.0, 0.5);
    for (std::size_t block = 1; block < count && watch.goesOn(0, block, count); block += Watch::kTurns) {
        for (std::size_t i = block; i < std::min(count, block + Watch::kTurns); ++i) {
            changes += sampleAt<kSize>(bytes.data(), i) != sampleAt<kSize>(bytes.data(), i - 1) ? 1U : 0U;
        }
    }
    watch.setStage(0.5, 1.0);
    capture.runs.reserve(std::min(changes, capture.most_runs));
    std::size_t begin = 0;
    std::uint32_t levels = sampleAt<kSize>(bytes.data(), 0);
    for (std::size_t i = 1; i < count && !capture.is_cut && watch.goesOn(i, i, count); ++i) {
        const std::uint32_t now = sampleAt<kSize>(bytes.data(), i);
        if (now != levels) {
            capture.append(levels, i - begin);
            levels = now;
            begin = i;
        }
    }
    if (!watch.hasStopped()) {
        capture.append(levels, count - begin);
    }
}

}  // namespace

void LineCapture::append(std::uint32_t levels, std::uint64_t samples) {
    constexpr std::uint32_t kLongest = UINT32_MAX;
    if (samples > kLongestStretch) {
        cut(QCoreApplication::translate("LineCapture", "A level stays longer than can be kept; what comes after is left out."));
    }
    while (samples > 0 && !is_cut) {
        if (runs.empty() || runs.back().levels != levels || runs.back().samples == kLongest) {
            if (runs.size() >= most_runs) {
                cut(QCoreApplication::translate("LineCapture", "The lines change more than %1 times; what comes after is left out.")
                        .arg(most_runs));
                return;
            }
            runs.push_back({levels, 0});
        }
        const auto fit = static_cast<std::uint32_t>(std::min<std::uint64_t>(kLongest - runs.back().samples, samples));
        runs.back().samples += fit;
        samples -= fit;
    }
}

void LineCapture::cut(const QString& why) {
    if (!is_cut) {
        is_cut = true;
        doubts.push_back({runs.empty() ? 0 : runs.size() - 1, why, false});
    }
}

std::uint64_t LineCapture::samples() const {
    return std::accumulate(runs.begin(), runs.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const LevelRun& run) { return sum + run.samples; });
}

LineCapture captureFromSamples(std::string_view bytes, std::optional<double> samples_per_s, int bytes_per_sample,
                               const Progress& progress) {
    const int size = std::clamp(bytes_per_sample, 1, 4);
    LineCapture capture;
    capture.lines = 8 * size;
    capture.samples_per_s = samples_per_s;
    Watch watch(progress);
    switch (size) {
        case 1:
            appendSamples<1>(capture, bytes, watch);
            break;
        case 2:
            appendSamples<2>(capture, bytes, watch);
            break;
        case 3:
            appendSamples<3>(capture, bytes, watch);
            break;
        default:
            appendSamples<4>(capture, bytes, watch);
    }
    return capture;
}

}  // namespace pmts::protocol
