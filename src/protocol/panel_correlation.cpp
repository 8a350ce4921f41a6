#include "pmts/protocol/panel_correlation.hpp"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <tuple>

namespace pmts::protocol {
namespace {

constexpr std::size_t kMostMatches = 10;
constexpr double kLeastScore = 0.02;
constexpr double kArcSecond_deg = 1.0 / 3600.0;

/// A number as a panel shows it, in degrees where it is sexagesimal.
struct PanelNumber {
    double value = 0.0;
    double last_place = 1.0;
    bool sexagesimal = false;
    int decimals = 0;
};

std::optional<PanelNumber> sexagesimal(const QStringList& parts) {
    std::array<double, 3> values{};
    for (qsizetype i = 0; i < 3; ++i) {
        bool ok = false;
        values[static_cast<std::size_t>(i)] = parts[i].toUInt(&ok);
        if (!ok || (i > 0 && values[static_cast<std::size_t>(i)] >= 60.0)) {
            return std::nullopt;
        }
    }
    return PanelNumber{.value = values[0] + values[1] / 60.0 + values[2] / 3600.0,
                       .last_place = kArcSecond_deg,
                       .sexagesimal = true};
}

std::optional<PanelNumber> panelNumber(const QString& text) {
    const QString plain = text.trimmed().replace(QLatin1Char(','), QLatin1Char('.'));
    const QStringList parts = plain.split(QLatin1Char('.'));
    if (parts.size() == 3) {
        return sexagesimal(parts);
    }
    bool ok = false;
    PanelNumber number{.value = plain.toDouble(&ok)};
    number.decimals = parts.size() == 2 ? static_cast<int>(parts[1].size()) : 0;
    number.last_place = std::pow(10.0, -number.decimals);
    return ok && std::isfinite(number.value) ? std::optional(number) : std::nullopt;  // toDouble() takes "nan"
}

/// From the stream's number to the panel's; `times` is exact.
struct Conversion {
    const char* words;
    double times;
    bool sexagesimal;
};

constexpr std::array kConversions{
    Conversion{QT_TRANSLATE_NOOP("PanelCorrelation", "as it stands"), 1.0, false},
    Conversion{QT_TRANSLATE_NOOP("PanelCorrelation", "gon, shown as d.mm.ss"), 0.9, true},
    Conversion{QT_TRANSLATE_NOOP("PanelCorrelation", "degrees, shown as d.mm.ss"), 1.0, true},
    Conversion{QT_TRANSLATE_NOOP("PanelCorrelation", "gon, shown in degrees"), 0.9, false},
    Conversion{QT_TRANSLATE_NOOP("PanelCorrelation", "degrees, shown in gon"), 1.0 / 0.9, false},
    Conversion{QT_TRANSLATE_NOOP("PanelCorrelation", "gon, shown in mil"), 16.0, false},
    Conversion{QT_TRANSLATE_NOOP("PanelCorrelation", "m, shown in ft"), 1.0 / 0.3048, false},
    Conversion{QT_TRANSLATE_NOOP("PanelCorrelation", "ft, shown in m"), 0.3048, false},
};

QString shownText(double value, const PanelNumber& number) {
    if (!number.sexagesimal) {
        return QString::number(value, 'f', number.decimals);
    }
    const auto seconds = static_cast<long long>(std::llround(value * 3600.0));
    return QStringLiteral("%1.%2.%3")
        .arg(seconds / 3600)
        .arg(seconds / 60 % 60, 2, 10, QLatin1Char('0'))
        .arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

/// The value that fits best, of one variable in one conversion.
struct Nearest {
    StreamValue stream;
    double off = 0.0;
};

/// Unit, variable, place in kConversions.
using Trial = std::tuple<char, int, std::size_t>;

std::map<Trial, Nearest> nearestOf(const std::vector<StreamValue>& values, const PanelNumber& number) {
    std::map<Trial, Nearest> nearest;
    for (std::size_t i = 0; i < kConversions.size(); ++i) {
        if (kConversions[i].sexagesimal != number.sexagesimal) {
            continue;
        }
        for (const StreamValue& value : values) {
            const double off = (value.value * kConversions[i].times - number.value) / number.last_place;
            const auto [known, is_new] = nearest.try_emplace({value.unit, value.variable, i}, Nearest{value, off});
            if (!is_new && std::abs(off) < std::abs(known->second.off)) {
                known->second = {value, off};
            }
        }
    }
    return nearest;
}

PanelMatch matchOf(const Nearest& nearest, const Conversion& conversion, const PanelNumber& number) {
    const double beyond = std::max(0.0, std::abs(nearest.off) - 0.5);  // half of the last place is rounding
    return {.stream = nearest.stream,
            .units = QCoreApplication::translate("PanelCorrelation", conversion.words),
            .shown = shownText(nearest.stream.value * conversion.times, number),
            .off = nearest.off,
            .score = 1.0 / (1.0 + beyond * beyond)};
}

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }

/// `A,166=96.16838`, or `7=10.2345` as a station answers.
std::optional<StreamValue> valueIn(std::string_view line, std::uint64_t sample) {
    StreamValue value{.unit = 'G', .sample = sample};
    if (line.size() >= 5 && isUpper(line[0]) && line[1] == ',') {
        value.unit = line[0];
        line.remove_prefix(2);
    }
    const char* const end = line.data() + line.size();
    const auto [sign, number_error] = std::from_chars(line.data(), end, value.variable);
    if (number_error != std::errc() || sign == end || *sign != '=' || value.variable < 0) {
        return std::nullopt;
    }
    const auto [rest, value_error] = std::from_chars(sign + 1, end, value.value);
    const bool is_number = value_error == std::errc() && rest == end && std::isfinite(value.value);  // from_chars takes "inf"
    return is_number ? std::optional(value) : std::nullopt;
}

}  // namespace

std::vector<StreamValue> streamValues(std::span<const DecodedCharacter> characters) {
    std::vector<StreamValue> values;
    std::string line;
    std::uint64_t begin = 0;
    bool sure = true;
    for (const DecodedCharacter& character : characters) {
        if (line.empty() && sure) {
            begin = character.sample;
        }
        sure = sure && character.isSure();
        if (character.value >= 0x20) {
            line += static_cast<char>(character.value);
            continue;
        }
        const auto value = valueIn(line, begin);
        if (value && sure) {
            values.push_back(*value);
        }
        line.clear();
        sure = character.isSure();  // behind a doubtful end the next line may be the rest of this one
    }
    return values;
}

core::Result<std::vector<PanelMatch>> correlated(const QString& panel_text, const std::vector<StreamValue>& values) {
    const auto number = panelNumber(panel_text);
    if (!number) {
        return core::fail(core::ErrorKind::kBadInput,
                          QCoreApplication::translate("PanelCorrelation", "“%1” is no number of a panel.").arg(panel_text),
                          QCoreApplication::translate("PanelCorrelation", "Type it as it is shown: 86.33.06 or 96.1684."));
    }
    std::vector<PanelMatch> matches;
    for (const auto& [trial, nearest] : nearestOf(values, *number)) {
        matches.push_back(matchOf(nearest, kConversions[std::get<std::size_t>(trial)], *number));
    }
    std::erase_if(matches, [](const PanelMatch& match) { return match.score < kLeastScore; });
    std::ranges::stable_sort(matches, std::greater<>(), &PanelMatch::score);
    matches.resize(std::min(matches.size(), kMostMatches));
    return matches;
}

}  // namespace pmts::protocol
