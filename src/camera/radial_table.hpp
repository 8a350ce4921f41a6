#pragma once

#include "pmts/camera/lens.hpp"

#include <optional>

namespace pmts::camera::radial_table {

/// Throws std::logic_error unless the rows start at (0, 0) and rise strictly in both columns, to less than
/// 200 gon.
void requireMonotone(const RadialTableLens& lens);

/// d angle / d radius at each row, so that the cubic pieces never overshoot the rows (Fritsch and Butland
/// 1984).
[[nodiscard]] std::vector<double> slopes(const std::vector<RadialTableLens::Row>& rows);

/// Angle off the axis at a radius; nothing past the last row.
[[nodiscard]] std::optional<double> angleAtRadius(const std::vector<RadialTableLens::Row>& rows,
                                                  const std::vector<double>& slopes, double radius_px);

/// Inverse of angleAtRadius(): solves the same cubic piece, so that a round trip is exact to rounding.
[[nodiscard]] std::optional<double> radiusAtAngle(const std::vector<RadialTableLens::Row>& rows,
                                                  const std::vector<double>& slopes, double angle_rad);

}  // namespace pmts::camera::radial_table
