#pragma once

#include "pmts/core/result.hpp"

namespace pmts::atmosphere {

/// What the instrument's label 30 accepts.
inline constexpr double kLeastPpm = -60.0;
inline constexpr double kGreatestPpm = 195.0;

/// The maker's distance correction: ppm = 275 - 79.55 p / (273 + t), p in mbar, t in deg C.
/// Source: protocol page 4.5; p = 1000, t = 22 gives 5.34. It is zero near 15 deg C and 996 mbar.
/// Fails with ErrorKind::kLimit when the air is not breathable or the result outside the range of label 30.
[[nodiscard]] core::Result<double> makerPpm(double pressure_mbar, double temperature_degc);

}  // namespace pmts::atmosphere
