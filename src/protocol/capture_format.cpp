// What kind of file a capture is, told from its first bytes.
#include "pmts/protocol/line_capture.hpp"
#include "text_lines.hpp"

#include <algorithm>
#include <array>

namespace pmts::protocol {
namespace {

constexpr std::size_t kLooked = 4096;  ///< bytes that tell a format
constexpr std::size_t kLeastValues = 8;  ///< a dialogue has more different bytes than a line or three that are sampled
constexpr std::string_view kSessionHead = "# PMTS session log";

bool isText(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x20 || c == '\n' || c == '\r' || c == '\t';
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// `15-2` somewhere, and hardly anything but numbers and what stands between them.
bool isRunText(std::string_view head) {
    bool pair = false, comment = false;
    std::size_t fitting = 0, seen = 0;
    for (std::size_t i = 0; i < head.size(); ++i) {
        comment = head[i] == '#' || (comment && head[i] != '\n');
        if (comment) {
            continue;
        }
        ++seen;
        fitting += isDigit(head[i]) || std::string_view("-,; \t\r\n").find(head[i]) != std::string_view::npos ? 1U : 0U;
        pair = pair || (head[i] == '-' && i > 0 && isDigit(head[i - 1]));
    }
    return pair && 10 * fitting >= 9 * seen;
}

/// A row of numbers with a 0 or a 1 among them, behind remarks and one row of names.
bool isCsv(std::string_view head) {
    if (head.starts_with(';')) {
        return true;
    }
    int rows = 0;
    bool fits = false;
    (void)eachLine(head, [&](std::size_t, std::string_view line) -> core::Result<void> {
        if (!line.empty() && line.front() != ';' && rows < 2) {
            ++rows;
            const bool numbers = std::ranges::all_of(line, [](char c) { return isDigit(c) || c == ',' || c == '.' || c == ' '; });
            fits = fits || (numbers && (line.starts_with('0') || line.starts_with('1') || line.find(',') != std::string_view::npos));
        }
        return {};
    });
    return fits;
}

/// Mostly text, with ends of lines or blocks, and more different bytes than sampled lines give.
bool isDialogue(std::string_view head) {
    std::array<std::size_t, 256> times{};
    for (const char c : head) {
        ++times[static_cast<unsigned char>(c)];
    }
    const auto of = [&times](char c) { return times[static_cast<unsigned char>(c)]; };
    const std::size_t ends = of('\r') + of('\n') + of('\x04') + of('>');
    const auto shown = static_cast<std::size_t>(std::ranges::count_if(head, [](char c) { return c >= 0x20 && c < 0x7F; }));
    const auto values = static_cast<std::size_t>(std::ranges::count_if(times, [](std::size_t n) { return n > 0; }));
    return ends > 0 && values > kLeastValues && 10 * (shown + of('\r') + of('\n') + of('\x04')) >= 9 * head.size();
}

}  // namespace

CaptureFormat guessCaptureFormat(std::string_view bytes) {
    const std::string_view head = bytes.substr(0, kLooked);
    if (head.starts_with(kSessionHead)) {
        return CaptureFormat::kSession;
    }
    if (!std::ranges::all_of(head, isText)) {
        return isDialogue(head) ? CaptureFormat::kBytes : CaptureFormat::kSamples;
    }
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || isRunText(head.substr(first))) {
        return CaptureFormat::kRunText;
    }
    if (head[first] == '$') {
        return CaptureFormat::kVcd;
    }
    return isCsv(head.substr(first)) ? CaptureFormat::kCsv : CaptureFormat::kBytes;
}

}  // namespace pmts::protocol
