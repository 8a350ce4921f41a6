#include "unit_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace pmts::simulator {
namespace {

constexpr double kMetresPerFoot = 0.3048;
constexpr double kMbarPerMmHg = 1.333224;
constexpr double kMbarPerInHg = 33.86389;

/// Circle parts of an angle that is not negative.
std::string magnitudeText(core::Angle angle, AngleText unit, int decimals) {
    switch (unit) {
        case AngleText::kGon:
            return fixedText(angle.gon(), decimals);
        case AngleText::kDegree:
            return fixedText(angle.deg(), decimals);
        case AngleText::kMil:
            return fixedText(angle.mil(), decimals - 1);
        case AngleText::kDms:
            break;
    }
    const long long seconds = std::llround(angle.arcsec());
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%lld.%02lld%02lld", seconds / 3600, seconds / 60 % 60,
                  seconds % 60);
    return text.data();
}

/// ddd.mmss, missing digits are zeros; the seconds may go on with decimals.
std::optional<core::Angle> fromDms(std::string_view text) {
    const std::size_t point = std::min(text.find('.'), text.size());
    std::string digits(text.substr(std::min(point + 1, text.size())));
    digits.resize(std::max<std::size_t>(digits.size(), 4), '0');
    const auto degrees = plainNumber(point == 0 ? "0" : text.substr(0, point));
    const double minutes = plainNumber(digits.substr(0, 2)).value_or(60.0);
    const double seconds = plainNumber(digits.substr(2, 2) + "." + digits.substr(4) + "0").value_or(60.0);
    if (!degrees || minutes >= 60.0 || seconds >= 60.0) {
        return std::nullopt;
    }
    return core::Angle::fromArcsec(*degrees * 3600.0 + minutes * 60.0 + seconds);
}

bool isOneTurn(const std::string& text, AngleText unit) {
    const double turn = unit == AngleText::kGon ? 400.0 : unit == AngleText::kMil ? 6400.0 : 360.0;
    return plainNumber(text) == turn;
}

}  // namespace

std::optional<UnitDigits> unitDigits(std::string_view label_23, int mbar_digit) {
    if (label_23.size() != 4) {
        return std::nullopt;
    }
    const int angle = label_23[3] - '0', length = label_23[2] - '0';
    const int temperature = label_23[1] - '0', pressure = label_23[0] - '0';
    const auto within = [](int digit, int last) { return digit >= 1 && digit <= last; };
    if (!within(angle, 4) || !within(length, 2) || !within(temperature, 2) || !within(pressure, 3)) {
        return std::nullopt;
    }
    UnitDigits units{static_cast<AngleText>(angle), static_cast<LengthText>(length),
                     static_cast<TemperatureText>(temperature), PressureText::kInHg, std::string(label_23)};
    if (pressure != 3) {
        units.pressure = pressure == mbar_digit ? PressureText::kMbar : PressureText::kMmHg;
    }
    return units;
}

std::string angleText(core::Angle angle, AngleText unit, int decimals) {
    const std::string text = magnitudeText(core::normalized(angle), unit, decimals);
    return isOneTurn(text, unit) ? magnitudeText(core::Angle{}, unit, decimals) : text;
}

std::string signedAngleText(core::Angle angle, AngleText unit, int decimals) {
    const std::string magnitude = magnitudeText(core::abs(angle), unit, decimals);
    const bool is_zero = magnitude.find_first_not_of("0.") == std::string::npos;
    return angle < core::Angle{} && !is_zero ? "-" + magnitude : magnitude;
}

std::optional<core::Angle> angleFrom(std::string_view text, AngleText unit) {
    const auto number = plainNumber(text);
    if (!number) {
        return std::nullopt;
    }
    if (unit == AngleText::kDms) {
        const bool negative = text.starts_with('-');
        const auto magnitude = fromDms(text.substr(negative || text.starts_with('+') ? 1 : 0));
        return magnitude && negative ? std::optional(-*magnitude) : magnitude;
    }
    switch (unit) {
        case AngleText::kDegree:
            return core::Angle::fromDeg(*number);
        case AngleText::kMil:
            return core::Angle::fromMil(*number);
        default:
            return core::Angle::fromGon(*number);
    }
}

double lengthFactor(LengthText unit) { return unit == LengthText::kFoot ? 1.0 / kMetresPerFoot : 1.0; }

std::string fixedText(double value, int decimals) {
    std::array<char, 350> text{};  // to_chars knows no locale: the decimal sign stays a point
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed,
                                   std::max(decimals, 0))
                         .ptr;
    const std::string fixed(text.data(), end);
    const bool minus_zero = fixed.starts_with('-') && fixed.find_first_not_of("-0.") == std::string::npos;
    return minus_zero ? fixed.substr(1) : fixed;
}

std::optional<double> plainNumber(std::string_view text) {
    const std::size_t digits_at = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
    const std::string_view digits = text.substr(digits_at);
    const bool plain = digits.find_first_not_of("0123456789.") == std::string_view::npos &&
                       digits.find_first_of("0123456789") != std::string_view::npos &&
                       std::count(digits.begin(), digits.end(), '.') <= 1;
    if (!plain) {
        return std::nullopt;
    }
    double number = 0.0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return text.starts_with('-') ? -number : number;
}

double temperatureShown(double degc, TemperatureText unit) {
    return unit == TemperatureText::kFahrenheit ? degc * 1.8 + 32.0 : degc;
}

double temperatureMeant(double shown, TemperatureText unit) {
    return unit == TemperatureText::kFahrenheit ? (shown - 32.0) / 1.8 : shown;
}

double pressureShown(double mbar, PressureText unit) {
    return unit == PressureText::kMmHg   ? mbar / kMbarPerMmHg
           : unit == PressureText::kInHg ? mbar / kMbarPerInHg
                                         : mbar;
}

double pressureMeant(double shown, PressureText unit) {
    return unit == PressureText::kMmHg   ? shown * kMbarPerMmHg
           : unit == PressureText::kInHg ? shown * kMbarPerInHg
                                         : shown;
}

}  // namespace pmts::simulator
