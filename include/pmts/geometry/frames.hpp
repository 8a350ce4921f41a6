#pragma once

#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"

#include <Eigen/Core>

namespace pmts::geometry {

/// Station frame: origin at the telescope's optical centre, x at HA 100 gon (east), y at HA 0 (north), z up.
/// Alidade frame: the same origin, x along the trunnion axis to the right, y forward and level, z up.
/// Telescope frame: the alidade frame tilted about its x axis until y is the line of sight.
/// Columns are the carrier's axes in the station frame: p_station = stationFromAlidade(ha) * p_alidade.

/// The alidade stands at this circle reading; in face II the telescope then looks to the back of it.
[[nodiscard]] Eigen::Matrix3d stationFromAlidade(core::Angle ha);

/// Valid in both faces: its y column is the line of sight; above VA 200 gon its z column points down, because
/// a plunged telescope, and a camera strapped to it, stands on its head.
[[nodiscard]] Eigen::Matrix3d stationFromTelescope(const Pointing& pointing);

/// Unit vector of the line of sight in the station frame, either face.
[[nodiscard]] Eigen::Vector3d directionFromPointing(const Pointing& pointing);

/// Face I circle readings of a direction of any length, HA in [0, 400) gon.
/// Fails with ErrorKind::kUndefined when it is zero, not finite or within 1e-9 rad of the plumb line.
[[nodiscard]] core::Result<Pointing> pointingFromDirection(const Eigen::Vector3d& direction_station);

}  // namespace pmts::geometry
