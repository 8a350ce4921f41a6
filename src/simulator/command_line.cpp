#include "command_line.hpp"

#include <algorithm>
#include <charconv>

namespace pmts::simulator {
namespace {

constexpr std::string_view kVerbs = "RWPTOLKM";
constexpr std::string_view kUnits = "GRSVAMIUD*";

bool isArgument(char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '<' || c == '>'; }

/// Digits of a label or process number, one blank before them tolerated.
std::optional<int> numberFrom(std::string_view text) {
    if (text.starts_with(' ')) {
        text.remove_prefix(1);
    }
    int number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool digits_only = !text.empty() && text.front() != '-' && end == text.data() + text.size();
    return fault == std::errc() && digits_only && text.size() <= 3 ? std::optional(number) : std::nullopt;
}

/// The manuals' syntax boxes print `RG=[arg][,lbl]`: the same as `RG[arg][,lbl]`.
std::string withoutBoxForm(std::string_view line) {
    std::string plain(line);
    const bool box_form = line.size() >= 3 && line[0] == 'R' && line[2] == '=';
    return box_form ? plain.erase(2, 1) : plain;
}

}  // namespace

std::optional<CommandLine> parseCommandLine(std::string_view line) {
    const std::string plain = withoutBoxForm(line);
    const std::string_view text = plain;
    const std::size_t equals = text.find('=');
    std::string_view head = text.substr(0, equals);
    CommandLine command;
    if (equals != std::string_view::npos) {
        command.data = std::string(text.substr(equals + 1));
    }
    const std::size_t comma = head.find(',');
    if (comma != std::string_view::npos) {
        command.number = numberFrom(head.substr(comma + 1));
        if (!command.number) {
            return std::nullopt;
        }
        head = head.substr(0, comma);
    }
    if (head.empty() || kVerbs.find(head[0]) == std::string_view::npos) {
        return std::nullopt;
    }
    command.verb = head[0];
    if (head.size() == 1) {
        return command.verb == 'M' ? std::optional(command) : std::nullopt;
    }
    if (kUnits.find(head[1]) == std::string_view::npos) {
        return std::nullopt;
    }
    command.unit = head[1];
    command.arguments = std::string(head.substr(2));
    const bool known = std::all_of(command.arguments.begin(), command.arguments.end(), isArgument);
    return known ? std::optional(command) : std::nullopt;
}

}  // namespace pmts::simulator
