#include "pmts/core/angle_text.hpp"

#include <QRegularExpression>

#include <array>
#include <cstdint>

namespace pmts::core {
namespace {

constexpr QChar kDegreeSign(0x00B0);

tl::unexpected<Error> unreadable(QStringView text) {
    return fail(ErrorKind::kBadInput, QStringLiteral("\"%1\" is not an angle.").arg(text),
                QStringLiteral("Type for example 12.5 gon, 11°15'00\" or 5'."));
}

struct UnitName {
    const char* name;
    Angle one;
};

constexpr std::array kUnits{
    UnitName{"gon", Angle::fromGon(1)},   UnitName{"mgon", Angle::fromMgon(1)}, UnitName{"cc", Angle::fromCc(1)},
    UnitName{"deg", Angle::fromDeg(1)},   UnitName{"rad", Angle::fromRad(1)},   UnitName{"mil", Angle::fromMil(1)},
    UnitName{"°", Angle::fromDeg(1)},     UnitName{"'", Angle::fromDeg(1.0 / 60)}, UnitName{"\"", Angle::fromArcsec(1)},
};

std::optional<Angle> unitByName(const QString& name) {
    for (const auto& unit : kUnits) {
        if (name.compare(QString::fromUtf8(unit.name), Qt::CaseInsensitive) == 0) {
            return unit.one;
        }
    }
    return std::nullopt;
}

/// `ddd mm ss.s` without signs, the way DMS is typed on a number pad.
std::optional<Angle> bareSexagesimal(const QString& text) {
    static const QRegularExpression parts(
        QStringLiteral(R"(^([+-]?)(\d+)(?:\s+([0-5]?\d)(?:\s+([0-5]?\d(?:\.\d*)?))?)?$)"));
    const auto match = parts.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    const double deg = match.captured(2).toDouble() + match.captured(3).toDouble() / 60.0 +
                       match.captured(4).toDouble() / 3600.0;
    return Angle::fromDeg(match.captured(1) == u"-" ? -deg : deg);
}

Angle bareUnit(AngleUnit unit) {
    switch (unit) {
        case AngleUnit::kGon: return Angle::fromGon(1);
        case AngleUnit::kDms:
        case AngleUnit::kDegree: return Angle::fromDeg(1);
        case AngleUnit::kMil: return Angle::fromMil(1);
    }
    return Angle::fromGon(1);
}

/// Typographic primes, doubled apostrophes and the decimal comma, reduced to one way of writing.
QString plainSigns(QStringView text) {
    QString plain = text.trimmed().toString();
    plain.replace(QChar(0x2032), u'\'').replace(QChar(0x2019), u'\'');
    plain.replace(QChar(0x2033), u'"').replace(QChar(0x201D), u'"').replace(QStringLiteral("''"), QStringLiteral("\""));
    plain.replace(QChar(0x2212), u'-').replace(u',', u'.');
    return plain;
}

}  // namespace

Dms toDms(Angle angle, int second_decimals) {
    const double scale = std::pow(10.0, second_decimals);
    const auto units = static_cast<std::int64_t>(std::llround(std::abs(angle.arcsec()) * scale));
    const auto units_per_second = static_cast<std::int64_t>(scale);
    const std::int64_t whole_seconds = units / units_per_second;
    return {.negative = angle.gon() < 0 && units != 0,
            .degrees = static_cast<int>(whole_seconds / 3600),
            .minutes = static_cast<int>(whole_seconds / 60 % 60),
            .seconds = static_cast<double>(whole_seconds % 60) +
                       static_cast<double>(units % units_per_second) / scale};
}

QString angleNumber(Angle angle, AngleUnit unit, int decimals) {
    switch (unit) {
        case AngleUnit::kGon: return QString::number(angle.gon(), 'f', decimals);
        case AngleUnit::kDegree: return QString::number(angle.deg(), 'f', decimals);
        case AngleUnit::kMil: return QString::number(angle.mil(), 'f', decimals);
        case AngleUnit::kDms: break;
    }
    const Dms dms = toDms(angle, decimals);
    return QStringLiteral("%1%2 %3 %4")
        .arg(dms.negative ? QStringLiteral("-") : QString())
        .arg(dms.degrees)
        .arg(dms.minutes, 2, 10, QChar(u'0'))
        .arg(QString::number(dms.seconds, 'f', decimals).rightJustified(decimals > 0 ? decimals + 3 : 2, u'0'));
}

QString angleText(Angle angle, AngleUnit unit, int decimals) {
    switch (unit) {
        case AngleUnit::kGon: return angleNumber(angle, unit, decimals) + QStringLiteral(" gon");
        case AngleUnit::kDegree: return angleNumber(angle, unit, decimals) + kDegreeSign;
        case AngleUnit::kMil: return angleNumber(angle, unit, decimals) + QStringLiteral(" mil");
        case AngleUnit::kDms: break;
    }
    const QStringList parts = angleNumber(angle, unit, decimals).split(u' ');
    return parts[0] + kDegreeSign + parts[1] + u'\'' + parts[2] + u'"';
}

int usualDecimals(AngleUnit unit) {
    switch (unit) {
        case AngleUnit::kGon: return 4;
        case AngleUnit::kDms: return 0;
        case AngleUnit::kDegree: return 4;
        case AngleUnit::kMil: return 3;
    }
    return 4;
}

Result<Angle> angleFromText(QStringView text, AngleUnit default_unit) {
    const QString plain = plainSigns(text);
    if (default_unit == AngleUnit::kDms) {
        if (const auto angle = bareSexagesimal(plain)) {
            return *angle;
        }
    }
    static const QRegularExpression whole(
        QStringLiteral(R"(^([+-]?)\s*((?:\d+\.?\d*|\.\d+)\s*(?:[a-z]+|°|'|")?\s*)+$)"),
        QRegularExpression::CaseInsensitiveOption);
    const auto outer = whole.match(plain);
    if (!outer.hasMatch()) {
        return unreadable(text);
    }
    static const QRegularExpression term(QStringLiteral(R"((\d+\.?\d*|\.\d+)\s*([a-z]+|°|'|")?)"),
                                         QRegularExpression::CaseInsensitiveOption);
    Angle sum;
    int terms = 0;
    for (auto terms_found = term.globalMatch(plain); terms_found.hasNext(); ++terms) {
        const auto match = terms_found.next();
        const QString name = match.captured(2);
        const auto unit = name.isEmpty() ? std::optional(bareUnit(default_unit)) : unitByName(name);
        if (!unit || (name.isEmpty() && terms > 0)) {
            return unreadable(text);
        }
        sum += *unit * match.captured(1).toDouble();
    }
    return outer.captured(1) == u"-" ? -sum : sum;
}

}  // namespace pmts::core
