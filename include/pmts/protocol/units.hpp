#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/core/result.hpp"

#include <string>
#include <string_view>

namespace pmts::protocol {

enum class WireAngleUnit { kGon = 1, kDms = 2, kDegree = 3, kMil = 4 };
enum class WireLengthUnit { kMetre = 1, kFoot = 2 };
enum class WireTemperatureUnit { kCelsius = 1, kFahrenheit = 2 };
enum class WirePressureUnit { kMbar = 1, kMmHg = 2, kInHg = 3 };  ///< order of 1 and 2 unknown: a setting of the profile

/// Label 23, read from the right: angle, distance, temperature, pressure. 3214 is mil, metre, Fahrenheit, inHg.
struct WireUnits {
    WireAngleUnit angle = WireAngleUnit::kGon;
    WireLengthUnit length = WireLengthUnit::kMetre;
    WireTemperatureUnit temperature = WireTemperatureUnit::kCelsius;
    WirePressureUnit pressure = WirePressureUnit::kMbar;

    [[nodiscard]] bool operator==(const WireUnits&) const = default;
};

[[nodiscard]] core::Result<WireUnits> parseUnitStatus(std::string_view label_23);
[[nodiscard]] std::string unitStatusText(const WireUnits& units);

/// Angle as the instrument writes it; DMS is `ddd.mmss` (digits, not decimals), its seconds carry.
/// `decimals` counts digits after the point; within 9 digits in all (protocol page 2.3).
[[nodiscard]] std::string wireAngle(core::Angle angle, WireAngleUnit unit, int decimals);
[[nodiscard]] core::Result<core::Angle> angleFromWire(std::string_view text, WireAngleUnit unit);
[[nodiscard]] std::string wireLength(double length_m, WireLengthUnit unit, int decimals);
[[nodiscard]] core::Result<double> metresFromWire(std::string_view text, WireLengthUnit unit);

}  // namespace pmts::protocol
