#include "pmts/protocol/line_capture.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace pmts::protocol {
namespace {

constexpr std::size_t kLooked = 4096;  ///< bytes that tell a format

bool isText(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x20 || c == '\n' || c == '\r' || c == '\t';
}

}  // namespace

void LineCapture::append(std::uint32_t levels, std::uint64_t samples) {
    if (samples == 0) {
        return;
    }
    if (!runs.empty() && runs.back().levels == levels) {
        runs.back().samples += samples;
    } else {
        runs.push_back({levels, samples});
    }
}

std::uint64_t LineCapture::samples() const {
    return std::accumulate(runs.begin(), runs.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const LevelRun& run) { return sum + run.samples; });
}

LineCapture captureFromSamples(std::string_view bytes, std::optional<double> samples_per_s, int bytes_per_sample) {
    const auto size = static_cast<std::size_t>(std::clamp(bytes_per_sample, 1, 4));
    LineCapture capture;
    capture.lines = static_cast<int>(8 * size);
    capture.samples_per_s = samples_per_s;
    std::size_t begin = 0;
    while (begin + size <= bytes.size()) {
        const char* const first = bytes.data() + begin;
        std::size_t end = begin + size;
        while (end + size <= bytes.size() && std::memcmp(bytes.data() + end, first, size) == 0) {
            end += size;
        }
        std::uint32_t levels = 0;
        for (std::size_t i = 0; i < size; ++i) {
            levels |= static_cast<std::uint32_t>(static_cast<unsigned char>(first[i])) << (8 * i);
        }
        capture.append(levels, (end - begin) / size);
        begin = end;
    }
    return capture;
}

CaptureFormat guessCaptureFormat(std::string_view bytes) {
    const std::string_view head = bytes.substr(0, kLooked);
    if (!std::ranges::all_of(head, isText)) {
        return CaptureFormat::kSamples;
    }
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) {
        return CaptureFormat::kRunText;
    }
    if (head[first] == '$') {
        return CaptureFormat::kVcd;
    }
    const bool has_pairs = head.find('-') != std::string_view::npos && head[first] != ';';
    return has_pairs ? CaptureFormat::kRunText : CaptureFormat::kCsv;
}

}  // namespace pmts::protocol
