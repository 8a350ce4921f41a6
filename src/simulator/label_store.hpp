#pragma once

#include "pmts/protocol/labels.hpp"
#include "pmts/simulator/station_settings.hpp"
#include "unit_text.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace pmts::simulator {

/// Codes a write is refused with (protocol page 2.3).
inline constexpr int kAccepted = 0, kLabelUnknown = 20, kBadData = 35;

/// The instrument's clock: `2026.0601` and `14.3005`.
inline constexpr int kDate = 51, kTime = 52;
inline const QString kDateFormat = QStringLiteral("yyyy.MMdd"), kTimeFormat = QStringLiteral("HH.mmss");

/// The user labels 0-109 of one device. Angles, lengths, temperatures and pressures are kept as gon, metres,
/// deg C and mbar, so that the unit digits change their text; everything else is kept as it was written.
class LabelStore {
public:
    LabelStore(const StationSettings& settings, UnitDigits units);

    /// Info code: 0 accepted, 20 no such label, 35 bad or out of range, or the status for a label that is not
    /// set.
    int write(int label, std::string_view data);
    /// nullopt for a number without label. A label never set is an empty text or zero.
    [[nodiscard]] std::optional<std::string> text(int label) const;

    [[nodiscard]] double number(int label) const;  ///< in gon, m, deg C or mbar
    [[nodiscard]] const std::string& raw(int label) const;
    void setNumber(int label, double value);
    void setRaw(int label, std::string text);
    /// Text of a value as this label would show it.
    [[nodiscard]] std::string shown(const protocol::Label& label, double value) const;
    [[nodiscard]] const UnitDigits& units() const { return units_; }
    void reset();  ///< as after a lost memory

private:
    int writeNumber(const protocol::Label& label, std::string_view data);
    [[nodiscard]] bool digitsFit(std::string_view data) const;
    [[nodiscard]] std::optional<double> meant(const protocol::Label& label, std::string_view data) const;

    const StationSettings& settings_;
    UnitDigits units_;
    std::map<int, double> numbers_;
    std::map<int, std::string> texts_;
};

/// The station's formula, protocol page 4.5: ppm = 275 - 79.55 p / (273 + t). p = 1000, t = 22 gives 5.34.
[[nodiscard]] double makersPpm(double pressure_mbar, double temperature_degc);

}  // namespace pmts::simulator
