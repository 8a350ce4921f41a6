#include "pmts/protocol/command.hpp"

#include <QCoreApplication>

#include <charconv>
#include <optional>

namespace pmts::protocol {
namespace {

constexpr int kServiceLabel = 127;
constexpr int kFirstInternalLabel = 100;

/// Upper case, without blanks and control characters: what a tolerant firmware might still take for a
/// command.
std::string bareCommand(std::string_view line) {
    std::string bare;
    for (const char c : line) {
        if (c > 0x20 && c < 0x7F) {
            bare += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        }
    }
    return bare;
}

/// The number behind the first comma: a label, or a process after P.
std::optional<int> argumentNumber(std::string_view command) {
    const auto comma = command.find(',');
    if (comma == std::string_view::npos) {
        return std::nullopt;
    }
    int number = 0;
    const auto [end, error] =
        std::from_chars(command.data() + comma + 1, command.data() + command.size(), number);
    if (error == std::errc::result_out_of_range) {
        return kServiceLabel;  // nobody needs such a label
    }
    return error == std::errc{} ? std::optional(number) : std::nullopt;
}

const char* refusal(std::string_view command) {
    if (command.starts_with('K')) {
        return QT_TRANSLATE_NOOP("DenyList", "K erases files in the instrument");
    }
    if (command.starts_with("LV")) {
        return QT_TRANSLATE_NOOP("DenyList", "LV erases the instrument's program");
    }
    if (command.starts_with("OV")) {
        return QT_TRANSLATE_NOOP("DenyList", "OV is a service access");
    }
    const auto label = argumentNumber(command);
    if (label == kServiceLabel && !command.starts_with('P')) {
        return QT_TRANSLATE_NOOP("DenyList", "label 127 is a service access");
    }
    if (label >= kFirstInternalLabel && command.starts_with("WG")) {
        return QT_TRANSLATE_NOOP("DenyList", "labels from 100 on hold the instrument's calibration");
    }
    return nullptr;
}

core::Result<void> checkOneCommand(std::string_view line) {
    const char* reason = refusal(bareCommand(line));
    if (reason == nullptr) {
        return {};
    }
    return core::fail(
        core::ErrorKind::kRefused,
        QCoreApplication::translate("DenyList", "This command is not sent: %1.")
            .arg(QCoreApplication::translate("DenyList", reason)),
        QCoreApplication::translate("DenyList", "Use the control unit, or allow unsafe commands."),
        QString::fromLatin1(line));
}

}  // namespace

core::Result<void> checkDenyList(std::string_view line) {
    // A console may send several lines at once; the instrument starts each at its CR.
    while (!line.empty()) {
        const auto end = std::min(line.find_first_of("\r\n"), line.size());
        PMTS_TRY(checkOneCommand(line.substr(0, end)));
        line.remove_prefix(std::min(end + 1, line.size()));
    }
    return {};
}

}  // namespace pmts::protocol
