#include "pmts/app/settings/unit_format.hpp"

#include "pmts/core/quantity_expression.hpp"

namespace pmts::app {

QString UnitFormat::angle(core::Angle angle) const {
    return core::angleText(angle, angle_unit, core::usualDecimals(angle_unit));
}

QString UnitFormat::smallAngle(core::Angle angle) const {
    switch (angle_unit) {
        case core::AngleUnit::kGon: return QStringLiteral("%1 mgon").arg(angle.mgon(), 0, 'f', 1);
        case core::AngleUnit::kMil: return QStringLiteral("%1 mil").arg(angle.mil(), 0, 'f', 3);
        default: return QStringLiteral("%1\"").arg(angle.arcsec(), 0, 'f', 1);
    }
}

QString UnitFormat::direction(core::Angle ha) const {
    const QString text = angle(core::normalized(ha));
    return text == angle(core::Angle::fromGon(400)) ? angle(core::Angle()) : text;  // rounded up to a whole turn
}

QString UnitFormat::angleNumber(core::Angle angle) const {
    return core::angleNumber(angle, angle_unit, core::usualDecimals(angle_unit));
}

QString UnitFormat::directionNumber(core::Angle ha) const {
    const QString text = angleNumber(core::normalized(ha));
    return text == angleNumber(core::Angle::fromGon(400)) ? angleNumber(core::Angle()) : text;
}

QString UnitFormat::length(double length_m) const { return core::lengthText(length_m, length_unit, length_decimals); }

QString UnitFormat::lengthNumber(double length_m) const {
    return core::lengthNumber(length_m, length_unit, length_decimals);
}

QString UnitFormat::precision(double sigma_m) const {
    if (length_unit == core::LengthUnit::kFoot) {
        return QStringLiteral("± ") + core::lengthText(sigma_m, length_unit, 3);
    }
    const double sigma_mm = sigma_m * 1e3;
    return QStringLiteral("± %1 mm").arg(sigma_mm, 0, 'f', sigma_mm < 9.95 ? 1 : 0);
}

QString UnitFormat::angleUnitSign() const {
    switch (angle_unit) {
        case core::AngleUnit::kGon: return QStringLiteral("gon");
        case core::AngleUnit::kDms: return QStringLiteral("° ′ ″");
        case core::AngleUnit::kDegree: return QStringLiteral("°");
        case core::AngleUnit::kMil: return QStringLiteral("mil");
    }
    return {};
}

QString UnitFormat::lengthUnitSign() const { return core::unitName(length_unit); }

core::Result<core::Angle> UnitFormat::parseAngle(QStringView text) const {
    return core::angleFromExpression(text, angle_unit);
}

core::Result<double> UnitFormat::parseLengthM(QStringView text) const {
    return core::lengthFromExpression(text, length_unit);
}

}  // namespace pmts::app
