#include "pmts/protocol/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pmts::protocol {
namespace {

constexpr int kMostDigits = 9;
constexpr double kMetresPerFoot = 0.3048;
constexpr double kMbarPerMmHg = 1.33322387415;
constexpr double kMbarPerInHg = 33.8638866667;

tl::unexpected<core::Error> unreadable(const QString& what, std::string_view text) {
    return core::fail(core::ErrorKind::kProtocol,
                      QStringLiteral("The instrument sent %1 that cannot be read.").arg(what),
                      QStringLiteral("Repeat the action; when it stays, check cable and line settings."),
                      QString::fromLatin1(text));
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool areDigits(std::string_view text) { return std::ranges::all_of(text, isDigit); }

std::string_view trimmed(std::string_view text) {
    const auto first = std::min(text.find_first_not_of(' '), text.size());
    const auto last = text.find_last_not_of(' ');
    return text.substr(first, last == std::string_view::npos ? 0 : last - first + 1);
}

struct Decimal {
    bool negative = false;
    std::string_view whole;
    std::string_view fraction;
};

std::optional<Decimal> splitDecimal(std::string_view text) {
    Decimal parts;
    if (text.starts_with('-') || text.starts_with('+')) {
        parts.negative = text.front() == '-';
        text.remove_prefix(1);
    }
    const auto point = std::min(text.find('.'), text.size());
    parts.whole = text.substr(0, point);
    parts.fraction = text.substr(std::min(point + 1, text.size()));
    const bool readable = areDigits(parts.whole) && areDigits(parts.fraction) &&
                          !(parts.whole.empty() && parts.fraction.empty());
    return readable ? std::optional(parts) : std::nullopt;
}

std::int64_t powerOfTen(int exponent) {
    std::int64_t power = 1;
    for (; exponent > 0; --exponent) {
        power *= 10;
    }
    return power;
}

/// Decimals that leave room for the whole part within nine digits.
int fittingDecimals(double value, int decimals) {
    int fitting = std::clamp(decimals, 0, kMostDigits - 1);
    double limit = std::pow(10.0, kMostDigits - fitting);
    while (fitting > 0 && std::abs(value) >= limit) {
        --fitting;
        limit *= 10.0;
    }
    return fitting;
}

/// `units` counted in 10^-decimals, as text.
std::string fixedPoint(bool negative, std::int64_t units, int decimals) {
    std::string digits = std::to_string(units);
    if (decimals > 0) {
        const auto least = static_cast<std::size_t>(decimals) + 1;
        digits.insert(0, digits.size() < least ? least - digits.size() : 0, '0');
        digits.insert(digits.size() - static_cast<std::size_t>(decimals), 1, '.');
    }
    return negative && units != 0 ? "-" + digits : digits;
}

/// Rounded in the decimal the reader sees: 177.56115 becomes 177.5612 although the double is a little below.
std::int64_t roundedUnits(double value, double units_per_one) {
    constexpr double kHairAboveHalf = 1e-6;
    return static_cast<std::int64_t>(std::floor(std::abs(value) * units_per_one + 0.5 + kHairAboveHalf));
}

/// The value written with `decimals`; what reaches `full_circle` only by rounding starts the circle again.
std::string decimalAngle(double value, double full_circle, int decimals) {
    const int fitting = fittingDecimals(value, decimals);
    const auto per_one = powerOfTen(fitting);
    std::int64_t units = roundedUnits(value, static_cast<double>(per_one));
    const auto circle = static_cast<std::int64_t>(full_circle) * per_one;
    if (units == circle && std::abs(value) < full_circle) {
        units = 0;
    }
    return fixedPoint(value < 0.0, units, fitting);
}

/// Arc seconds in one unit of the last place of `ddd.mmss...` with this many digits behind the point.
double arcsecPerLastDigit(int decimals) {
    static constexpr std::array kCoarse{3600.0, 600.0, 60.0, 10.0};
    return decimals < 4 ? kCoarse.at(static_cast<std::size_t>(decimals)) : std::pow(10.0, 4 - decimals);
}

std::string dmsAngle(core::Angle angle, int decimals) {
    const int fitting = fittingDecimals(angle.deg(), decimals);
    const double step_arcsec = arcsecPerLastDigit(fitting);
    std::int64_t steps = roundedUnits(angle.arcsec(), 1.0 / step_arcsec);
    const auto steps_per_circle = static_cast<std::int64_t>(std::llround(360.0 * 3600.0 / step_arcsec));
    if (steps == steps_per_circle && core::abs(angle).deg() < 360.0) {
        steps = 0;
    }
    // Counted in the finest place in use, so that 59.6" has carried already.
    const auto per_second = powerOfTen(std::max(0, fitting - 4));
    const auto fine = fitting < 4 ? steps * static_cast<std::int64_t>(step_arcsec) : steps;
    const auto seconds = fine / per_second;
    const auto digits =
        (seconds / 3600 * 10000 + seconds / 60 % 60 * 100 + seconds % 60) * per_second + fine % per_second;
    return fixedPoint(angle.gon() < 0.0, fitting < 4 ? digits / powerOfTen(4 - fitting) : digits, fitting);
}

double toDouble(std::string_view digits) {
    double value = 0.0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

/// `159.48` is 48 minutes, `159.4` is 40: digits that are not written are zero.
core::Result<core::Angle> angleFromDms(std::string_view text) {
    const auto parts = splitDecimal(text);
    if (!parts) {
        return unreadable(QStringLiteral("an angle"), text);
    }
    std::string fraction(parts->fraction);
    fraction.append(fraction.size() < 4 ? 4 - fraction.size() : 0, '0');
    const double minutes = toDouble(std::string_view(fraction).substr(0, 2));
    const double seconds = toDouble(fraction.substr(2, 2) + "." + fraction.substr(4) + "0");
    if (minutes >= 60.0 || seconds >= 60.0) {
        return unreadable(QStringLiteral("an angle"), text);
    }
    const double deg = toDouble(parts->whole) + minutes / 60.0 + seconds / 3600.0;
    return core::Angle::fromDeg(parts->negative ? -deg : deg);
}

core::Result<core::Angle> angleFromDecimal(std::string_view text, WireAngleUnit unit) {
    const auto value = numberFromWire(text);
    if (!value) {
        return unreadable(QStringLiteral("an angle"), text);
    }
    switch (unit) {
        case WireAngleUnit::kDegree:
            return core::Angle::fromDeg(*value);
        case WireAngleUnit::kMil:
            return core::Angle::fromMil(*value);
        case WireAngleUnit::kGon:
        case WireAngleUnit::kDms:
            break;
    }
    return core::Angle::fromGon(*value);
}

double mbarPer(WirePressureUnit unit) {
    switch (unit) {
        case WirePressureUnit::kMbar:
            return 1.0;
        case WirePressureUnit::kMmHg:
            return kMbarPerMmHg;
        case WirePressureUnit::kInHg:
            return kMbarPerInHg;
    }
    return 1.0;
}

template <class Unit>
std::optional<Unit> unitDigit(char digit, Unit last) {
    const int number = digit - '0';
    return number >= 1 && number <= static_cast<int>(last) ? std::optional(static_cast<Unit>(number))
                                                           : std::nullopt;
}

}  // namespace

core::Result<WireUnits> parseUnitStatus(std::string_view label_23) {
    const std::string_view text = trimmed(label_23);
    if (text.size() == 4) {
        const auto pressure = unitDigit(text[0], WirePressureUnit::kInHg);
        const auto temperature = unitDigit(text[1], WireTemperatureUnit::kFahrenheit);
        const auto length = unitDigit(text[2], WireLengthUnit::kFoot);
        const auto angle = unitDigit(text[3], WireAngleUnit::kMil);
        if (pressure && temperature && length && angle) {
            return WireUnits{*angle, *length, *temperature, *pressure};
        }
    }
    return unreadable(QStringLiteral("a unit setting (label 23)"), label_23);
}

std::string unitStatusText(const WireUnits& units) {
    const auto digit = [](auto unit) { return static_cast<char>('0' + static_cast<int>(unit)); };
    return {digit(units.pressure), digit(units.temperature), digit(units.length), digit(units.angle)};
}

std::string wireAngle(core::Angle angle, WireAngleUnit unit, int decimals) {
    switch (unit) {
        case WireAngleUnit::kGon:
            return decimalAngle(angle.gon(), 400.0, decimals);
        case WireAngleUnit::kDms:
            return dmsAngle(angle, decimals);
        case WireAngleUnit::kDegree:
            return decimalAngle(angle.deg(), 360.0, decimals);
        case WireAngleUnit::kMil:
            return decimalAngle(angle.mil(), 6400.0, decimals);
    }
    throw std::logic_error("unknown angle unit");
}

core::Result<core::Angle> angleFromWire(std::string_view text, WireAngleUnit unit) {
    constexpr core::Angle kMost = core::Angle::fromGon(400.0) + core::Angle::fromCc(0.01);
    const auto angle =
        unit == WireAngleUnit::kDms ? angleFromDms(trimmed(text)) : angleFromDecimal(text, unit);
    if (angle && core::abs(*angle) > kMost) {
        return unreadable(QStringLiteral("an angle"), text);
    }
    return angle;
}

std::string wireLength(double length_m, WireLengthUnit unit, int decimals) {
    return wireNumber(unit == WireLengthUnit::kFoot ? length_m / kMetresPerFoot : length_m, decimals);
}

core::Result<double> metresFromWire(std::string_view text, WireLengthUnit unit) {
    const double factor = unit == WireLengthUnit::kFoot ? kMetresPerFoot : 1.0;
    return numberFromWire(text).map([factor](double value) { return value * factor; });
}

std::string wireTemperature(double temperature_degc, WireTemperatureUnit unit, int decimals) {
    const bool fahrenheit = unit == WireTemperatureUnit::kFahrenheit;
    return wireNumber(fahrenheit ? temperature_degc * 1.8 + 32.0 : temperature_degc, decimals);
}

core::Result<double> degcFromWire(std::string_view text, WireTemperatureUnit unit) {
    const bool fahrenheit = unit == WireTemperatureUnit::kFahrenheit;
    return numberFromWire(text).map(
        [fahrenheit](double value) { return fahrenheit ? (value - 32.0) / 1.8 : value; });
}

std::string wirePressure(double pressure_mbar, WirePressureUnit unit, int decimals) {
    return wireNumber(pressure_mbar / mbarPer(unit), decimals);
}

core::Result<double> mbarFromWire(std::string_view text, WirePressureUnit unit) {
    return numberFromWire(text).map([factor = mbarPer(unit)](double value) { return value * factor; });
}

std::string wireNumber(double value, int decimals) {
    if (!(std::abs(value) < std::pow(10.0, kMostDigits))) {
        throw std::logic_error("a number of the instrument has at most nine digits");
    }
    const int fitting = fittingDecimals(value, decimals);
    return fixedPoint(value < 0.0, roundedUnits(value, static_cast<double>(powerOfTen(fitting))), fitting);
}

core::Result<double> numberFromWire(std::string_view text) {
    const std::string_view plain = trimmed(text);
    const auto parts = splitDecimal(plain);
    if (!parts || parts->whole.size() + parts->fraction.size() > 15) {
        return unreadable(QStringLiteral("a number"), text);
    }
    const double value = toDouble(plain.starts_with('-') || plain.starts_with('+') ? plain.substr(1) : plain);
    return parts->negative ? -value : value;
}

core::Result<LineParameters> parseLineParameters(std::string_view label_78) {
    std::vector<int> fields;
    std::string_view rest = trimmed(label_78);
    while (!rest.empty()) {
        const auto end = std::min(rest.find('.'), rest.size());
        const std::string_view field = rest.substr(0, end);
        if (field.empty() || field.size() > 6 || !areDigits(field)) {
            return unreadable(QStringLiteral("line parameters (label 78)"), label_78);
        }
        fields.push_back(static_cast<int>(toDouble(field)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const bool sensible = fields.size() == 4 && (fields[0] == 1 || fields[0] == 2) &&
                          (fields[1] == 7 || fields[1] == 8) && fields[2] <= 2 && fields[3] >= 50 &&
                          fields[3] <= 115200;
    if (!sensible) {
        return unreadable(QStringLiteral("line parameters (label 78)"), label_78);
    }
    return LineParameters{
        .stop_bits = fields[0], .data_bits = fields[1], .parity = fields[2], .baud = fields[3]};
}

std::string lineParametersText(const LineParameters& line) {
    return std::to_string(line.stop_bits) + "." + std::to_string(line.data_bits) + "." +
           std::to_string(line.parity) + "." + std::to_string(line.baud);
}

}  // namespace pmts::protocol
