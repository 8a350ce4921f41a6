#pragma once

#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"

#include <Eigen/Core>

namespace pmts::geometry {

/// A half line in the station frame, metres.
struct Ray {
    Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  ///< unit length

    [[nodiscard]] Eigen::Vector3d at(double distance_m) const { return origin_m + distance_m * direction; }
};

/// The telescope's line of sight: from the optical centre to what it points at, either face.
[[nodiscard]] Ray lineOfSight(const Pointing& pointing);

/// First point of the ray that is `radius_m` away from the station's origin: where a camera beside the
/// telescope sees what the telescope measures at that slope distance. Fails with ErrorKind::kUndefined when
/// the ray never is, or the radius is not a positive number.
[[nodiscard]] core::Result<Eigen::Vector3d> intersectSphere(const Ray& ray, double radius_m);

/// Shortest distance from a point to the half line, metres.
[[nodiscard]] double distanceToRay(const Ray& ray, const Eigen::Vector3d& p_station);

}  // namespace pmts::geometry
