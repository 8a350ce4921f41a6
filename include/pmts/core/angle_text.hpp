#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/core/result.hpp"

#include <QString>
#include <QStringView>

namespace pmts::core {

/// The units an angle is shown and typed in.
enum class AngleUnit { kGon, kDms, kDegree, kMil };

/// Degrees, minutes and seconds of an angle after rounding the seconds: 59.6" carries into the minute.
struct Dms {
    bool negative = false;
    int degrees = 0;
    int minutes = 0;
    double seconds = 0.0;
};

/// Sexagesimal parts, seconds rounded to `second_decimals`; never 60 seconds nor 60 minutes.
[[nodiscard]] Dms toDms(Angle angle, int second_decimals = 0);

/// Text with its unit sign: `177.5612 gon`, `159°48'18"`, `159.8050°`, `2840.978 mil`.
/// `decimals` counts decimals of the gon, degree or mil, and for DMS those of the second.
[[nodiscard]] QString angleText(Angle angle, AngleUnit unit, int decimals);

/// The same without a unit sign, for columns whose header carries the unit: `159 48 18` for DMS.
[[nodiscard]] QString angleNumber(Angle angle, AngleUnit unit, int decimals);

/// Decimals that show one cc (0.0001 gon) in the unit: 4, 0, 4, 3 would show 0.1 mgon, 1", 0.36", 1 cc.
[[nodiscard]] int usualDecimals(AngleUnit unit);

/// Reads what a person types: `12.5`, `12.5 gon`, `5'`, `12°30'`, `12 30 15` (DMS), `30 cc`, `2 mgon`, `1.2 rad`,
/// `100 mil`; a bare number has `default_unit`. A decimal comma is understood.
/// Fails with ErrorKind::kBadInput naming the text.
[[nodiscard]] Result<Angle> angleFromText(QStringView text, AngleUnit default_unit);

}  // namespace pmts::core
