#pragma once

#include "pmts/core/result.hpp"

#include <QString>
#include <QStringView>

namespace pmts::core {

/// The units a length is shown and typed in. The foot is the international one, 0.3048 m exactly.
enum class LengthUnit { kMetre, kFoot };

inline constexpr double kMetresPerFoot = 0.3048;

/// Text with its unit: `1.600 m`, `5.249 ft`. What rounds to zero has no sign.
[[nodiscard]] QString lengthText(double length_m, LengthUnit unit, int decimals);

/// The same without the unit, for columns whose header carries it.
[[nodiscard]] QString lengthNumber(double length_m, LengthUnit unit, int decimals);

/// Decimals that show a millimetre: 3 in metres and in feet (0.001 ft is 0.3 mm).
[[nodiscard]] int usualDecimals(LengthUnit unit);

/// `m` or `ft`.
[[nodiscard]] QString unitName(LengthUnit unit);

/// Reads what a person types, in metres: `1.6`, `1.6 m`, `5.25 ft`, `120 mm`, `12 cm`, `0.3 km`, `10 in`;
/// a bare number has `default_unit`. A decimal comma is understood.
/// Fails with ErrorKind::kBadInput naming the text.
[[nodiscard]] Result<double> lengthFromText(QStringView text, LengthUnit default_unit);

}  // namespace pmts::core
