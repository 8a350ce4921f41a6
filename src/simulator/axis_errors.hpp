#pragma once

#include "pmts/geometry/pointing.hpp"
#include "pmts/simulator/station_settings.hpp"

namespace pmts::simulator {

/// What the circles show for a true line of sight, and back, without noise. Both faces:
///     HA = HA_true + c / sin(VA_true) + i cot(VA_true) + tilt_across cot(VA_true)    VA = VA_true + z +
///     tilt_along
/// with c collimation, i trunnion, z index error. Above VA 200 gon the sine changes sign, so the mean of both
/// faces is free of c, i and z. The tilt of the standing axis counts only while the compensator is off.
[[nodiscard]] geometry::Pointing circleReading(const StationSettings& errors,
                                               const geometry::Pointing& true_pointing, bool compensated);
[[nodiscard]] geometry::Pointing trueFromReading(const StationSettings& errors,
                                                 const geometry::Pointing& reading, bool compensated);

}  // namespace pmts::simulator
