#include "pmts/protocol/wire_words.hpp"

#include "pmts/protocol/info_code.hpp"
#include "pmts/protocol/labels.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <array>
#include <charconv>

namespace pmts::protocol {
namespace {

constexpr std::array kModeNames{"STD", "TRK", "D-bar", "FSTD", "D-bar, high resolution"};

QString tr(const char* text) { return QCoreApplication::translate("WireWords", text); }

QString textOf(std::string_view bytes) { return QString::fromLatin1(bytes); }

std::string_view withoutEnd(std::string_view command) {
    while (!command.empty() && (command.back() == '\r' || command.back() == '\n')) {
        command.remove_suffix(1);
    }
    return command;
}

std::optional<int> wholeNumber(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = error == std::errc{} && end == text.data() + text.size() && number >= 0;
    return whole ? std::optional(number) : std::nullopt;
}

QString angleSign(WireAngleUnit unit) {
    switch (unit) {
        case WireAngleUnit::kGon: return QStringLiteral("gon");
        case WireAngleUnit::kDms: return QStringLiteral("d.mmss");
        case WireAngleUnit::kDegree: return QStringLiteral("°");
        case WireAngleUnit::kMil: return QStringLiteral("mil");
    }
    return {};
}

QString pressureSign(WirePressureUnit unit) {
    switch (unit) {
        case WirePressureUnit::kMbar: return QStringLiteral("mbar");
        case WirePressureUnit::kMmHg: return QStringLiteral("mmHg");
        case WirePressureUnit::kInHg: return QStringLiteral("inHg");
    }
    return {};
}

QString unitSign(LabelUnit unit, const WireUnits& units) {
    const QString length = units.length == WireLengthUnit::kMetre ? QStringLiteral("m") : QStringLiteral("ft");
    switch (unit) {
        case LabelUnit::kNone: return {};
        case LabelUnit::kLength: return length;
        case LabelUnit::kArea: return length + QStringLiteral("²");
        case LabelUnit::kVolume: return length + QStringLiteral("³");
        case LabelUnit::kAngle: return angleSign(units.angle);
        case LabelUnit::kPercent: return QStringLiteral("%");
        case LabelUnit::kPpm: return QStringLiteral("ppm");
        case LabelUnit::kTemperature:
            return units.temperature == WireTemperatureUnit::kCelsius ? QStringLiteral("°C") : QStringLiteral("°F");
        case LabelUnit::kPressure: return pressureSign(units.pressure);
    }
    return {};
}

QString labelName(int number) {
    const Label* const label = findLabel(number);
    return label && !label->prompt.empty() ? textOf(label->prompt) : tr("label %1").arg(number);
}

/// `10.2345 gon`; the number stands as the instrument wrote it.
QString valueText(int number, std::string_view data, const std::optional<WireUnits>& units) {
    const Label* const label = findLabel(number);
    const QString sign = label && units ? unitSign(label->unit, *units) : QString();
    const QString value = data.empty() ? tr("nothing") : textOf(data).trimmed();
    return sign.isEmpty() ? value : value + u' ' + sign;
}

/// The letters of a reading command, `RG`, `RRN`, `RGD`, and the label behind the comma.
struct Reading {
    ReadForm form = ReadForm::kStandard;
    std::optional<int> label;
};

std::optional<ReadForm> formOf(std::string_view letter) {
    if (letter.empty()) {
        return ReadForm::kStandard;
    }
    switch (letter.size() == 1 ? letter[0] : '\0') {
        case 'N': return ReadForm::kNames;
        case 'D': return ReadForm::kDataOnly;
        case 'V': return ReadForm::kSeparate;
        default: return std::nullopt;
    }
}

std::optional<Reading> readingOf(std::string_view command) {
    if (!command.starts_with("RG") && !command.starts_with("RR")) {
        return std::nullopt;
    }
    const auto comma = command.find(',');
    const auto form = formOf(command.substr(2, comma == std::string_view::npos ? comma : comma - 2));
    if (!form) {
        return std::nullopt;
    }
    Reading reading{.form = *form, .label = std::nullopt};
    if (comma != std::string_view::npos) {
        reading.label = wholeNumber(command.substr(comma + 1));
        if (!reading.label) {
            return std::nullopt;
        }
    }
    return reading;
}

std::optional<QString> writingInWords(std::string_view command, const std::optional<WireUnits>& units) {
    const auto equals = command.find('=');
    if ((!command.starts_with("WG,") && !command.starts_with("WR,")) || equals == std::string_view::npos) {
        return std::nullopt;
    }
    const auto label = wholeNumber(command.substr(3, equals - 3));
    if (!label) {
        return std::nullopt;
    }
    return tr("write %1 = %2").arg(labelName(*label), valueText(*label, command.substr(equals + 1), units));
}

/// `WS=PH05V05`: both axes to the targets of labels 26 and 27.
std::optional<QString> positionInWords(std::string_view command) {
    if (!command.starts_with("WS=P")) {
        return std::nullopt;
    }
    QStringList axes;
    for (auto rest = command.substr(4); rest.size() >= 3; rest.remove_prefix(3)) {
        axes.append(tr("%1 to %2 cc").arg(rest[0] == 'H' ? QStringLiteral("HA") : QStringLiteral("VA"),
                                          QString::number(wholeNumber(rest.substr(1, 2)).value_or(0))));
    }
    return tr("turn to the target (%1)").arg(axes.join(QStringLiteral(", ")));
}

std::optional<QString> modeInWords(std::string_view command) {
    if (!command.starts_with("PG,3=")) {
        return std::nullopt;
    }
    const auto mode = wholeNumber(command.substr(5));
    return mode && static_cast<std::size_t>(*mode) < kModeNames.size()
               ? tr("measuring mode %1").arg(QLatin1String(kModeNames[static_cast<std::size_t>(*mode)]))
               : tr("measuring mode");
}

std::optional<QString> fileCommandInWords(std::string_view command) {
    if (command.size() < 2) {
        return std::nullopt;
    }
    const auto equals = command.find('=');
    const QString name = equals == std::string_view::npos ? QString() : textOf(command.substr(equals + 1));
    switch (command[0]) {
        case 'O': return command.size() == 3 && command[2] == 'C' ? tr("list files") : tr("send file %1").arg(name).trimmed();
        case 'L': return tr("take file %1").arg(name).trimmed();
        case 'K': return tr("erase file %1").arg(name).trimmed();
        case 'M': return tr("ask for free memory");
        default: return std::nullopt;
    }
}

std::optional<QString> plainCommandInWords(std::string_view command) {
    if (command == "RGT") {
        return tr("test the signal");
    }
    if (command == "TG" || command == "TG<" || command == "TG>") {
        return tr("measure the distance");
    }
    if (command == "PV,20") {
        return tr("calibrate the compensator");
    }
    if (command == "PV,21") {
        return tr("switch the instrument off");
    }
    return std::nullopt;
}

QString itemInWords(const Item& item, const std::optional<int>& asked, const std::optional<WireUnits>& units) {
    const std::optional<int> label = item.label ? item.label : asked;
    if (label) {
        return labelName(*label) + u' ' + valueText(*label, item.data, units);
    }
    const QString data = textOf(item.data).trimmed();
    return item.name.empty() ? data : textOf(item.name).trimmed() + u' ' + data;
}

}  // namespace

std::optional<QString> commandInWords(std::string_view bytes, const std::optional<WireUnits>& units) {
    const std::string_view command = withoutEnd(bytes);
    if (const auto plain = plainCommandInWords(command)) {
        return plain;
    }
    if (const auto reading = readingOf(command)) {
        return reading->label ? tr("read %1").arg(labelName(*reading->label)) : tr("read the measurement");
    }
    for (const auto& words : {writingInWords(command, units), positionInWords(command), modeInWords(command)}) {
        if (words) {
            return words;
        }
    }
    return fileCommandInWords(command);
}

ReplyShape shapeOfAnswerTo(std::string_view bytes) {
    const std::string_view command = withoutEnd(bytes);
    const auto reading = readingOf(command);
    if (!reading) {
        return {.form = ReadForm::kStandard, .one_label = false, .file = command.starts_with('O')};
    }
    return {.form = reading->form, .one_label = reading->label.has_value(), .file = false};
}

QString replyInWords(std::string_view command, const Reply& reply, const std::optional<WireUnits>& units) {
    const auto reading = readingOf(withoutEnd(command));
    const std::optional<int> asked = reading ? reading->label : std::nullopt;
    QStringList parts;
    if (reply.damaged) {
        parts.append(tr("damaged"));
    }
    if (reply.status && reply.status->code != 0) {
        parts.append(tr("info %1: %2").arg(reply.status->code).arg(infoCode(reply.status->code).happened));
    }
    for (const Item& item : reply.items) {
        parts.append(itemInWords(item, asked, units));
    }
    return parts.isEmpty() ? tr("done") : parts.join(QStringLiteral(", "));
}

}  // namespace pmts::protocol
