#include "pmts/core/length_text.hpp"

#include <QCoreApplication>
#include <QRegularExpression>

#include <array>
#include <optional>

namespace pmts::core {
namespace {

struct UnitName {
    const char* name;
    double one_m;
};

constexpr std::array kUnits{
    UnitName{"m", 1.0},  UnitName{"cm", 0.01},           UnitName{"mm", 0.001},  UnitName{"km", 1000.0},
    UnitName{"dm", 0.1}, UnitName{"ft", kMetresPerFoot}, UnitName{"in", 0.0254},
};

std::optional<double> unitByName(const QString& name) {
    for (const auto& unit : kUnits) {
        if (name.compare(QLatin1String(unit.name), Qt::CaseInsensitive) == 0) {
            return unit.one_m;
        }
    }
    return std::nullopt;
}

double one(LengthUnit unit) { return unit == LengthUnit::kFoot ? kMetresPerFoot : 1.0; }

tl::unexpected<Error> unreadable(QStringView text) {
    return fail(ErrorKind::kBadInput,
                QCoreApplication::translate("pmts::core", "\"%1\" is not a length.").arg(text),
                QCoreApplication::translate("pmts::core", "Type for example 1.6 m, 5.25 ft or 120 mm."));
}

}  // namespace

QString unitName(LengthUnit unit) {
    return unit == LengthUnit::kFoot ? QStringLiteral("ft") : QStringLiteral("m");
}

int usualDecimals(LengthUnit /*unit*/) { return 3; }

QString lengthNumber(double length_m, LengthUnit unit, int decimals) {
    const QString number = QString::number(length_m / one(unit), 'f', decimals);
    static const QRegularExpression zero(QStringLiteral("^-[0.]*$"));
    return zero.match(number).hasMatch() ? number.mid(1) : number;
}

QString lengthText(double length_m, LengthUnit unit, int decimals) {
    return lengthNumber(length_m, unit, decimals) + u' ' + unitName(unit);
}

Result<double> lengthFromText(QStringView text, LengthUnit default_unit) {
    QString plain = text.trimmed().toString();
    plain.replace(QChar(0x2212), u'-').replace(u',', u'.');
    static const QRegularExpression form(QStringLiteral(R"(^([+-]?)\s*(\d+\.?\d*|\.\d+)\s*([a-z]*)$)"),
                                         QRegularExpression::CaseInsensitiveOption);
    const auto match = form.match(plain);
    if (!match.hasMatch()) {
        return unreadable(text);
    }
    const QString name = match.captured(3);
    const auto unit = name.isEmpty() ? std::optional(one(default_unit)) : unitByName(name);
    if (!unit) {
        return unreadable(text);
    }
    const double length_m = match.captured(2).toDouble() * *unit;
    return match.captured(1) == u"-" ? -length_m : length_m;
}

}  // namespace pmts::core
