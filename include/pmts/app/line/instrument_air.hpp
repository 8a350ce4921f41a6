#pragma once

#include <QString>

#include <optional>

namespace pmts::app {

/// The air an instrument corrects its distances for, as its labels have it. Absent what it did not tell.
struct InstrumentAir {
    std::optional<double> temperature_degc;  ///< label 56
    std::optional<double> pressure_mbar;     ///< label 74
    std::optional<double> humidity_percent;  ///< label 65
    std::optional<double> ppm;               ///< label 30

    [[nodiscard]] bool operator==(const InstrumentAir&) const = default;
    [[nodiscard]] bool isEmpty() const { return *this == InstrumentAir(); }
    /// `20.0 °C, 1013.2 mbar, 60 %, 12.0 ppm`
    [[nodiscard]] QString text() const;
};

}  // namespace pmts::app
