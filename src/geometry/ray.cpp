#include "pmts/geometry/ray.hpp"

#include "pmts/geometry/frames.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::geometry {

Ray lineOfSight(const Pointing& pointing) { return {.direction = directionFromPointing(pointing)}; }

core::Result<Eigen::Vector3d> intersectSphere(const Ray& ray, double radius_m) {
    // |origin + t direction| = radius; the part of the origin across the ray keeps its digits far away too.
    const double along_m = ray.origin_m.dot(ray.direction);
    const double across2_m2 = (ray.origin_m - along_m * ray.direction).squaredNorm();
    const double half_chord2_m2 = radius_m * radius_m - across2_m2;
    if (std::isfinite(radius_m) && radius_m > 0.0 && half_chord2_m2 >= 0.0) {
        const double half_chord_m = std::sqrt(half_chord2_m2);
        const double first_m = -along_m - half_chord_m;
        const double last_m = -along_m + half_chord_m;
        if (last_m >= 0.0) {
            return ray.at(first_m >= 0.0 ? first_m : last_m);
        }
    }
    return core::fail(
        core::ErrorKind::kUndefined,
        QCoreApplication::translate("Geometry", "The line of view never reaches this distance."),
        QCoreApplication::translate("Geometry", "Enter a longer distance."));
}

double distanceToRay(const Ray& ray, const Eigen::Vector3d& p_station) {
    const double along_m = std::max(0.0, (p_station - ray.origin_m).dot(ray.direction));
    return (p_station - ray.at(along_m)).norm();
}

}  // namespace pmts::geometry
