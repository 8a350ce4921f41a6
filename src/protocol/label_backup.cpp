#include "pmts/protocol/label_backup.hpp"

#include "pmts/protocol/labels.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace pmts::protocol {
namespace {

constexpr std::string_view kFirstLine = "# PMTS backup of instrument labels";
constexpr std::string_view kDate = "# date: ", kSerial = "# serial number: ", kTemperatureHead = "# temperature: ";
constexpr std::string_view kSilent = "?";
constexpr int kClockDate = 51, kClockTime = 52;

/// Page 3.2 without 127, 247, 250 and the transport labels; what stands on no list is not asked for.
constexpr int kServiceLabels[] = {100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115,
                                  116, 117, 118, 119, 120, 121, 122, 123, 130, 131, 136, 138, 139, 140, 149, 152,
                                  153, 155, 156, 157, 165, 166, 167, 168, 169, 172, 175, 176, 179, 180, 181, 182,
                                  183, 187, 188, 209, 210, 211, 212, 213, 214, 215, 216, 217, 218, 219, 220, 221};
constexpr int kUserLabels = 100;

core::Error badLine(int number, std::string_view line) {
    return {.kind = core::ErrorKind::kBadInput,
            .happened = QCoreApplication::translate("LabelBackup", "Line %1 of the backup cannot be read.").arg(number),
            .remedy = QCoreApplication::translate("LabelBackup", "Choose a backup that PMTS wrote."),
            .info_code = std::nullopt,
            .detail = QString::fromLatin1(line)};
}

bool takeHead(LabelBackup& backup, std::string_view line) {
    if (!line.starts_with('#')) {
        return false;
    }
    if (line.starts_with(kDate)) {
        const auto date = line.substr(kDate.size());
        backup.utc =
            QDateTime::fromString(QString::fromLatin1(date), Qt::ISODate);
    } else if (line.starts_with(kSerial)) {
        backup.serial_number = line.substr(kSerial.size());
    } else if (line.starts_with(kTemperatureHead)) {
        backup.temperature = line.substr(kTemperatureHead.size());
    }
    return true;
}

std::optional<LabelReading> readingIn(std::string_view line) {
    LabelReading reading;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), reading.label);
    const auto at = static_cast<std::size_t>(end - line.data());
    if (error != std::errc{} || at >= line.size()) {
        return std::nullopt;
    }
    if (line.substr(at) == kSilent) {
        return reading;
    }
    const auto rest = line.substr(at + 1);
    if (line[at] == '!') {
        reading.refused = parseStatus(rest);
        return reading.refused ? std::optional(reading) : std::nullopt;
    }
    reading.data = std::string(rest);
    reading.steady = line[at] == '=';
    return line[at] == '=' || line[at] == '~' ? std::optional(reading) : std::nullopt;
}

bool isSetting(int number) {
    const Label* const label = findLabel(number);
    const bool moves =
        label != nullptr && (label->access == LabelAccess::kMeasured || label->access == LabelAccess::kCalculated);
    return !moves && number != kClockDate && number != kClockTime;
}

std::string statusText(const Status& status) {
    return std::to_string(status.code) + (status.suffix ? '.' + std::to_string(*status.suffix) : std::string());
}

std::string valueText(const LabelReading& reading) {
    if (reading.isSilent()) {
        return std::string(kSilent);
    }
    return reading.refused ? '!' + statusText(*reading.refused) : (reading.steady ? '=' : '~') + *reading.data;
}

}  // namespace

const std::vector<int>& backupLabels() {
    static const std::vector<int> labels = [] {
        std::vector<int> all(kUserLabels);
        std::iota(all.begin(), all.end(), 0);
        all.insert(all.end(), std::begin(kServiceLabels), std::end(kServiceLabels));
        return all;
    }();
    return labels;
}

std::string backupText(const LabelBackup& backup) {
    std::string text(kFirstLine);
    text += '\n' + std::string(kDate) + backup.utc.toUTC().toString(Qt::ISODate).toStdString();
    text += '\n' + std::string(kSerial) + backup.serial_number;
    text += '\n' + std::string(kTemperatureHead) + backup.temperature + '\n';
    for (const LabelReading& reading : backup.readings) {
        text += std::to_string(reading.label);
        text += valueText(reading) + '\n';
    }
    return text;
}

core::Result<LabelBackup> parseBackup(std::string_view text) {
    LabelBackup backup;
    for (int number = 1; !text.empty(); ++number) {
        const auto end = std::min(text.find('\n'), text.size());
        auto line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with('\r')) {
            line.remove_suffix(1);
        }
        if (number == 1 && line != kFirstLine) {
            return tl::unexpected(badLine(number, line));
        }
        if (line.empty() || takeHead(backup, line)) {
            continue;
        }
        const auto reading = readingIn(line);
        if (!reading) {
            return tl::unexpected(badLine(number, line));
        }
        backup.readings.push_back(*reading);
    }
    return backup.readings.empty() ? core::Result<LabelBackup>(tl::unexpected(badLine(1, {}))) : backup;
}

std::vector<LabelChange> changesBetween(const LabelBackup& before, const LabelBackup& after) {
    std::map<int, LabelChange> labels;
    std::set<int> silent;
    for (const auto& [backup, side] : {std::pair{&before, &LabelChange::before}, {&after, &LabelChange::after}}) {
        for (const LabelReading& reading : backup->readings) {
            labels[reading.label].*side = reading.data;
            if (reading.isSilent()) {
                silent.insert(reading.label);
            }
        }
    }
    std::vector<LabelChange> changes;
    for (auto& [label, change] : labels) {
        if (change.before != change.after && !silent.contains(label)) {
            change.label = label;
            change.is_setting = isSetting(label);
            changes.push_back(change);
        }
    }
    return changes;
}

}  // namespace pmts::protocol
