#pragma once

#include "pmts/core/angle.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace pmts::simulator {

// The simulator's own reading and writing of numbers: the driver's is another, so that each checks the other.

enum class AngleText { kGon = 1, kDms = 2, kDegree = 3, kMil = 4 };
enum class LengthText { kMetre = 1, kFoot = 2 };
enum class TemperatureText { kCelsius = 1, kFahrenheit = 2 };
enum class PressureText { kMbar, kMmHg, kInHg };

/// Label 23, four digits read from the right: angle, length, temperature, pressure.
struct UnitDigits {
    AngleText angle = AngleText::kGon;
    LengthText length = LengthText::kMetre;
    TemperatureText temperature = TemperatureText::kCelsius;
    PressureText pressure = PressureText::kMbar;
    std::string text = "1111";
};

/// nullopt when a digit has no meaning. `mbar_digit` 1 or 2: the page does not know which of them is mbar.
[[nodiscard]] std::optional<UnitDigits> unitDigits(std::string_view label_23, int mbar_digit);

/// `decimals` for gon and degree; mil has one less, DMS is always ddd.mmss and carries. One full turn is
/// written 0.
[[nodiscard]] std::string angleText(core::Angle angle, AngleText unit, int decimals);
/// The same without wrapping to [0, 400): for differences and corrections.
[[nodiscard]] std::string signedAngleText(core::Angle angle, AngleText unit, int decimals);
[[nodiscard]] std::optional<core::Angle> angleFrom(std::string_view text, AngleText unit);

[[nodiscard]] double lengthFactor(LengthText unit);  ///< units in a metre
[[nodiscard]] std::string fixedText(double value, int decimals);
/// Plain decimal, optional sign; nullopt for anything else (letters, blanks, exponents, nothing).
[[nodiscard]] std::optional<double> plainNumber(std::string_view text);

[[nodiscard]] double temperatureShown(double degc, TemperatureText unit);
[[nodiscard]] double temperatureMeant(double shown, TemperatureText unit);
[[nodiscard]] double pressureShown(double mbar, PressureText unit);
[[nodiscard]] double pressureMeant(double shown, PressureText unit);

}  // namespace pmts::simulator
