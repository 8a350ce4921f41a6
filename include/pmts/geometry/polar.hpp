#pragma once

#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"

#include <Eigen/Core>

namespace pmts::geometry {

/// A pointing of the telescope and the distance measured along it.
struct PolarPoint {
    Pointing pointing{};
    double slope_distance_m = 0.0;  ///< optical centre to target, ppm already applied, > 0
};

/// Position of an observed point in the station frame, metres, 3x1 (x east, y north, z up).
///     x = SD sin(VA) sin(HA)    y = SD sin(VA) cos(HA)    z = SD cos(VA)
/// Source: PMTS reference, section 4 (thesis eq. 4.1-4.3 with sine and cosine of HA exchanged back).
/// Error: rounding only, below 1e-9 m up to 10 km. Both faces of one pointing give the same point.
[[nodiscard]] Eigen::Vector3d stationFromPolar(const PolarPoint& observed);

/// Inverse of stationFromPolar(), always in face I with HA in [0, 400) gon.
/// Fails with ErrorKind::kUndefined when the point is within 1e-6 m of the vertical axis: HA is then undefined.
[[nodiscard]] core::Result<PolarPoint> polarFromStation(const Eigen::Vector3d& p_station);

/// The same direction observed in the other face: HA + 200 gon, VA -> 400 gon - VA.
[[nodiscard]] Pointing otherFace(const Pointing& pointing);

/// True for a pointing in face II (VA above 200 gon).
[[nodiscard]] bool isFaceTwo(const Pointing& pointing);

/// The target in the face the reference is in: a move there never goes through the zenith.
[[nodiscard]] Pointing inFaceOf(const Pointing& reference, const Pointing& target);

/// Angle between two lines of sight, [0, 200] gon, accurate to 0.001 cc for small angles too.
[[nodiscard]] core::Angle separation(const Pointing& a, const Pointing& b);

}  // namespace pmts::geometry
