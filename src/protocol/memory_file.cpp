#include "pmts/protocol/memory_file.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace pmts::protocol {
namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::size_t kMostLabelDigits = 3;

std::string_view trimmed(std::string_view text, std::string_view what = kBlanks) {
    const auto begin = text.find_first_not_of(what);
    return begin == std::string_view::npos ? std::string_view()
                                           : text.substr(begin, text.find_last_not_of(what) - begin + 1);
}

std::optional<int> labelIn(std::string_view text) {
    int label = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), label);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    return whole && text.size() <= kMostLabelDigits && text.front() != '-' ? std::optional(label) : std::nullopt;
}

bool isDashes(std::string_view data) { return data.size() > 1 && data.find_first_not_of('-') == std::string_view::npos; }

void addItem(MemoryFile& file, int number, std::string_view item) {
    const auto equals = item.find('=');
    if (equals == std::string_view::npos) {
        file.bad.push_back({number, BadLineKind::kNoEquals, std::string(item)});
        return;
    }
    const auto label_text = trimmed(item.substr(0, equals));
    const auto label = label_text.empty() ? std::nullopt : labelIn(label_text);
    const auto data = item.substr(equals + 1);
    if (!label || trimmed(data).empty()) {
        file.bad.push_back({number, label ? BadLineKind::kNoData : BadLineKind::kNoLabel, std::string(item)});
    } else {
        file.lines.push_back({number, *label, std::string(data)});
    }
}

/// `"12,4=---- 5=101 "`: a running number, then items parted by blanks.
void addDumpLine(MemoryFile& file, int number, std::string_view line) {
    file.is_geodat_dump = true;
    line = trimmed(line, " \t\"");
    const auto comma = line.find(',');
    if (comma != std::string_view::npos && comma < line.find('=')) {
        line.remove_prefix(comma + 1);
    }
    while (!(line = trimmed(line)).empty()) {
        const auto item = line.substr(0, line.find_first_of(kBlanks));
        line.remove_prefix(item.size());
        const auto equals = item.find('=');
        if (equals == std::string_view::npos || !isDashes(item.substr(equals + 1))) {
            addItem(file, number, item);
        }
    }
}

}  // namespace

MemoryFile parseMemoryFile(std::string_view bytes) {
    MemoryFile file;
    for (int number = 1; !bytes.empty(); ++number) {
        const auto end = std::min(bytes.find_first_of("\r\n"), bytes.size());
        const auto line = bytes.substr(0, end);
        const bool cr_lf = bytes.substr(end).starts_with("\r\n");
        bytes.remove_prefix(std::min(end + (cr_lf ? 2 : 1), bytes.size()));
        if (const auto text = trimmed(line); text.starts_with('"')) {
            addDumpLine(file, number, text);
        } else if (!text.empty()) {
            addItem(file, number, line);
        }
    }
    return file;
}

std::string memoryFileText(const std::vector<MemoryLine>& lines) {
    std::string text;
    for (const MemoryLine& line : lines) {
        text += std::to_string(line.label) + '=' + line.data + "\r\n";
    }
    return text;
}

}  // namespace pmts::protocol
