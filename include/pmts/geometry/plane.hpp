#pragma once

#include "pmts/geometry/ray.hpp"

#include <vector>

namespace pmts::geometry {

/// All p with normal . p + offset = 0, station frame, metres (thesis: C1 X + C2 Y + C3 Z + K = 0).
/// The normal has unit length and points to the side on which the station stands (offset_m >= 0).
struct Plane {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double offset_m = 0.0;
};

/// A plane with what it leaves unexplained.
struct PlaneFit {
    Plane plane;
    std::vector<double> residuals_m;  ///< signed distance of each point, in the order given
    double rms_m = 0.0;               ///< root of sum of squares over (points - 3); 0 for three points
    double largest_m = 0.0;           ///< largest absolute residual
};

/// Least squares of the perpendicular distances, by the smallest singular vector of the centred points.
/// Fails with ErrorKind::kBadInput below three points and kUndefined when they lie on one line (the second
/// singular value is below 1e-6 of the first).
[[nodiscard]] core::Result<PlaneFit> fitPlane(const std::vector<Eigen::Vector3d>& points_station);

/// Where the ray meets the plane. Fails with ErrorKind::kUndefined when it runs parallel to it (below 1e-9
/// rad) or the plane is behind its origin.
[[nodiscard]] core::Result<Eigen::Vector3d> intersect(const Ray& ray, const Plane& plane);

/// Metres from the plane, positive on the side the normal points to.
[[nodiscard]] double signedDistance(const Plane& plane, const Eigen::Vector3d& p_station);

}  // namespace pmts::geometry
