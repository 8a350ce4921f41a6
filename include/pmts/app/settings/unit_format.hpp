#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/core/angle_text.hpp"
#include "pmts/core/length_text.hpp"
#include "pmts/core/result.hpp"

#include <QMetaType>
#include <QString>
#include <QStringView>

namespace pmts::app {

using LengthUnit = core::LengthUnit;

/// How quantities are written and read in every field. A value; the current one is in Preferences.
struct UnitFormat {
    core::AngleUnit angle_unit = core::AngleUnit::kGon;
    LengthUnit length_unit = LengthUnit::kMetre;
    int length_decimals = 3;

    [[nodiscard]] bool operator==(const UnitFormat&) const = default;

    /// With the unit sign: `177.5612 gon`.
    [[nodiscard]] QString angle(core::Angle angle) const;
    /// A residual: `0.3 mgon`, `1.1"`, `0.005 mil`.
    [[nodiscard]] QString smallAngle(core::Angle angle) const;
    /// HA in [0, 400) gon, never negative.
    [[nodiscard]] QString direction(core::Angle ha) const;
    /// Without the sign, for digits whose unit stands beside them or in the column header.
    [[nodiscard]] QString angleNumber(core::Angle angle) const;
    [[nodiscard]] QString directionNumber(core::Angle ha) const;
    /// With the unit sign: `23.418 m`.
    [[nodiscard]] QString length(double length_m) const;
    [[nodiscard]] QString lengthNumber(double length_m) const;
    /// A precision, always with sign and unit: `± 2 mm`, `± 0.007 ft`.
    [[nodiscard]] QString precision(double sigma_m) const;
    [[nodiscard]] QString angleUnitSign() const;   ///< `gon`, `DMS`, `°`, `mil`
    [[nodiscard]] QString lengthUnitSign() const;  ///< `m`, `ft`

    /// Any unit and arithmetic is understood; a bare number has the current unit. kBadInput names the text.
    [[nodiscard]] core::Result<core::Angle> parseAngle(QStringView text) const;
    [[nodiscard]] core::Result<double> parseLengthM(QStringView text) const;
};

}  // namespace pmts::app
