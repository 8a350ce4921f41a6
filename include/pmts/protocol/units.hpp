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
/// `decimals` counts digits after the point (DMS: 4 for `ddd.mmss`); within 9 digits in all (protocol page 2.3).
/// A direction below the full circle that rounds up to it is written as 0. No normalisation otherwise.
[[nodiscard]] std::string wireAngle(core::Angle angle, WireAngleUnit unit, int decimals);
/// Fails with kProtocol on anything but a number, on 60 minutes or seconds, beyond a full circle.
[[nodiscard]] core::Result<core::Angle> angleFromWire(std::string_view text, WireAngleUnit unit);
/// Foot is the international one, 0.3048 m.
[[nodiscard]] std::string wireLength(double length_m, WireLengthUnit unit, int decimals);
[[nodiscard]] core::Result<double> metresFromWire(std::string_view text, WireLengthUnit unit);
[[nodiscard]] std::string wireTemperature(double temperature_degc, WireTemperatureUnit unit, int decimals = 1);
[[nodiscard]] core::Result<double> degcFromWire(std::string_view text, WireTemperatureUnit unit);
[[nodiscard]] std::string wirePressure(double pressure_mbar, WirePressureUnit unit, int decimals = 1);
[[nodiscard]] core::Result<double> mbarFromWire(std::string_view text, WirePressureUnit unit);

/// A number without unit (ppm, scale factor), rounded half away from zero; decimals give way to the nine digits.
[[nodiscard]] std::string wireNumber(double value, int decimals);
/// Digits, one point, a sign, nothing else: `1.5e3`, `12,5` and a number with a damaged byte fail with kProtocol.
[[nodiscard]] core::Result<double> numberFromWire(std::string_view text);

/// Label 78, `1.8.0.9600`: stop bits, data bits, parity (0 none, 1 odd, 2 even), baud.
struct LineParameters {
    int stop_bits = 1;
    int data_bits = 8;
    int parity = 0;
    int baud = 9600;

    [[nodiscard]] bool operator==(const LineParameters&) const = default;
};
[[nodiscard]] core::Result<LineParameters> parseLineParameters(std::string_view label_78);
[[nodiscard]] std::string lineParametersText(const LineParameters& line);

}  // namespace pmts::protocol
