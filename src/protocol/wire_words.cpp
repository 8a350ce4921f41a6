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

/// What makes words of numbers: the units of label 23 where they are known, and the user's names.
struct Words {
    const std::optional<WireUnits>& units;
    const NameOf& name_of;
};

/// A label, and the unit that keeps it.
struct Place {
    char unit = 'G';
    int number = 0;
};

constexpr std::string_view kUnitLetters = "GRSVA";
constexpr int kStreamHa = 165, kStreamVa = 166;  ///< of the angle unit (protocol page 5.2)

/// Empty: the station, of which nobody says so.
QString ofUnit(char unit) {
    switch (unit) {
        case 'R': return tr(" of the control unit");
        case 'S': return tr(" of the servo");
        case 'V': return tr(" of the main board");
        case 'A': return tr(" of the angle unit");
        default: return {};
    }
}

QString labelName(const Place& place, const Words& words) {
    if (const QString named = words.name_of ? words.name_of(place.unit, place.number) : QString(); !named.isEmpty()) {
        return named;
    }
    if (place.unit == 'A' && (place.number == kStreamHa || place.number == kStreamVa)) {
        return place.number == kStreamHa ? QStringLiteral("HA") : QStringLiteral("VA");
    }
    const Label* const label = findLabel(place.number);
    const QString name = label && !label->prompt.empty() ? textOf(label->prompt) : tr("label %1").arg(place.number);
    return name + ofUnit(place.unit);
}

/// The bus always speaks in gon; what else its numbers are nobody has disclosed.
QString signOf(const Place& place, const Words& words) {
    if (place.unit == 'A') {
        return place.number == kStreamHa || place.number == kStreamVa ? QStringLiteral("gon") : QString();
    }
    const Label* const label = findLabel(place.number);
    const bool is_told = label && words.units && (place.unit == 'G' || place.unit == 'R');
    return is_told ? unitSign(label->unit, *words.units) : QString();
}

/// `10.2345 gon`; the number stands as the instrument wrote it.
QString valueText(const Place& place, std::string_view data, const Words& words) {
    const QString sign = signOf(place, words);
    const QString value = data.empty() ? tr("nothing") : textOf(data).trimmed();
    return sign.isEmpty() ? value : value + u' ' + sign;
}

/// The unit of a command with this verb, `RG`, `WV`; absent: another verb, or no unit that reads and writes.
std::optional<char> unitOf(std::string_view command, char verb) {
    const bool is_one = command.size() >= 2 && command[0] == verb && kUnitLetters.find(command[1]) != std::string_view::npos;
    return is_one ? std::optional(command[1]) : std::nullopt;
}

/// `A,166`, as the stream of the bus names its values.
std::optional<Place> placeOf(std::string_view name) {
    if (name.size() < 3 || name[1] != ',' || kUnitLetters.find(name[0]) == std::string_view::npos) {
        return std::nullopt;
    }
    const auto number = wholeNumber(name.substr(2));
    return number ? std::optional(Place{.unit = name[0], .number = *number}) : std::nullopt;
}

/// The letters of a reading command, `RG`, `RRN`, `RGD`, and the label behind the comma.
struct Reading {
    char unit = 'G';
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
    const auto unit = unitOf(command, 'R');
    if (!unit) {
        return std::nullopt;
    }
    const auto comma = command.find(',');
    const auto form = formOf(command.substr(2, comma == std::string_view::npos ? comma : comma - 2));
    if (!form) {
        return std::nullopt;
    }
    Reading reading{.unit = *unit, .form = *form, .label = std::nullopt};
    if (comma != std::string_view::npos) {
        reading.label = wholeNumber(command.substr(comma + 1));
        if (!reading.label) {
            return std::nullopt;
        }
    }
    return reading;
}

QString readingInWords(const Reading& reading, const Words& words) {
    if (reading.label) {
        return tr("read %1").arg(labelName({.unit = reading.unit, .number = *reading.label}, words));
    }
    return tr("read the measurement") + ofUnit(reading.unit);
}

/// What stands between the comma and the `=`, and what behind it.
struct Assignment {
    Place place;
    std::string_view data;
};

std::optional<Assignment> assignmentOf(std::string_view command, char verb) {
    const auto unit = unitOf(command, verb);
    const auto equals = command.find('=');
    if (!unit || equals == std::string_view::npos || equals < 4 || command[2] != ',') {
        return std::nullopt;
    }
    const auto number = wholeNumber(command.substr(3, equals - 3));
    return number ? std::optional(Assignment{.place = {.unit = *unit, .number = *number}, .data = command.substr(equals + 1)})
                  : std::nullopt;
}

std::optional<QString> writingInWords(std::string_view command, const Words& words) {
    const auto written = assignmentOf(command, 'W');
    return written ? std::optional(tr("write %1 = %2").arg(labelName(written->place, words), valueText(written->place, written->data, words)))
                   : std::nullopt;
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

/// Process 3 is the mode, of the bus too (protocol page 5.4); of the others only the numbers are known.
std::optional<QString> processInWords(std::string_view command) {
    const auto process = assignmentOf(command, 'P');
    if (!process) {
        return std::nullopt;
    }
    const auto [place, data] = *process;
    if (place.number == 3 && (place.unit == 'G' || place.unit == 'V')) {
        const auto mode = wholeNumber(data);
        return mode && static_cast<std::size_t>(*mode) < kModeNames.size()
                   ? tr("measuring mode %1").arg(QLatin1String(kModeNames[static_cast<std::size_t>(*mode)]))
                   : tr("measuring mode");
    }
    return tr("run process %1%2 with %3").arg(QString::number(place.number), ofUnit(place.unit), data.empty() ? tr("nothing") : textOf(data));
}

/// `PV,4`: without an argument.
std::optional<QString> bareProcessInWords(std::string_view command) {
    const auto unit = unitOf(command, 'P');
    const auto number = unit && command.size() > 3 && command[2] == ',' ? wholeNumber(command.substr(3)) : std::nullopt;
    return number ? std::optional(tr("run process %1%2").arg(QString::number(*number), ofUnit(*unit))) : std::nullopt;
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

QString itemInWords(const Item& item, const std::optional<Reading>& asked, const Words& words) {
    const auto label = item.label ? item.label : asked ? asked->label : std::nullopt;
    const auto place = label ? std::optional(Place{.unit = asked ? asked->unit : 'G', .number = *label}) : placeOf(item.name);
    if (place) {
        return labelName(*place, words) + u' ' + valueText(*place, item.data, words);
    }
    const QString data = textOf(item.data).trimmed();
    return item.name.empty() ? data : textOf(item.name).trimmed() + u' ' + data;
}

}  // namespace

std::optional<QString> commandInWords(std::string_view bytes, const std::optional<WireUnits>& units, const NameOf& name_of) {
    const std::string_view command = withoutEnd(bytes);
    const Words words{.units = units, .name_of = name_of};
    if (const auto plain = plainCommandInWords(command)) {
        return plain;
    }
    if (const auto reading = readingOf(command)) {
        return readingInWords(*reading, words);
    }
    for (const auto& said : {writingInWords(command, words), positionInWords(command), processInWords(command), bareProcessInWords(command)}) {
        if (said) {
            return said;
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

QString replyInWords(std::string_view command, const Reply& reply, const std::optional<WireUnits>& units, const NameOf& name_of) {
    const auto asked = readingOf(withoutEnd(command));
    const Words words{.units = units, .name_of = name_of};
    QStringList parts;
    if (reply.damaged) {
        parts.append(tr("damaged"));
    }
    if (reply.status && reply.status->code != 0) {
        const InfoCode info = infoCode(reply.status->code);
        parts.append(info.info_class == InfoClass::kOk ? info.happened : tr("info %1: %2").arg(info.code).arg(info.happened));
    }
    for (const Item& item : reply.items) {
        parts.append(itemInWords(item, asked, words));
    }
    return parts.isEmpty() ? tr("done") : parts.join(QStringLiteral(", "));
}

}  // namespace pmts::protocol
