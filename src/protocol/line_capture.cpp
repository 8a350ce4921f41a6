#include "pmts/protocol/line_capture.hpp"

#include <algorithm>
#include <cctype>
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

LineCapture captureFromSamples(std::string_view bytes, std::optional<double> samples_per_s) {
    LineCapture capture;
    capture.lines = 8;
    capture.samples_per_s = samples_per_s;
    std::size_t begin = 0;
    while (begin < bytes.size()) {
        const char level = bytes[begin];
        const std::size_t found = bytes.find_first_not_of(level, begin);
        const std::size_t end = found == std::string_view::npos ? bytes.size() : found;
        capture.append(static_cast<unsigned char>(level), end - begin);
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
