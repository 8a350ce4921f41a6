#include "pmts/geometry/plane.hpp"

#include <Eigen/SVD>
#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::geometry {
namespace {

Eigen::Matrix3Xd asColumns(const std::vector<Eigen::Vector3d>& points) {
    Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        columns.col(static_cast<Eigen::Index>(i)) = points[i];
    }
    return columns;
}

Plane facingTheStation(const Eigen::Vector3d& normal, const Eigen::Vector3d& p_on_plane) {
    const double offset_m = -normal.dot(p_on_plane);
    return offset_m < 0.0 ? Plane{-normal, -offset_m} : Plane{normal, offset_m};
}

PlaneFit withResiduals(const Plane& plane, const std::vector<Eigen::Vector3d>& points) {
    PlaneFit fit{.plane = plane, .residuals_m = {}};
    double sum2_m2 = 0.0;
    for (const Eigen::Vector3d& point : points) {
        const double residual_m = signedDistance(plane, point);
        fit.residuals_m.push_back(residual_m);
        fit.largest_m = std::max(fit.largest_m, std::abs(residual_m));
        sum2_m2 += residual_m * residual_m;
    }
    if (points.size() > 3) {
        fit.rms_m = std::sqrt(sum2_m2 / static_cast<double>(points.size() - 3));
    }
    return fit;
}

}  // namespace

core::Result<PlaneFit> fitPlane(const std::vector<Eigen::Vector3d>& points_station) {
    constexpr double kOnOneLine = 1e-6;
    if (points_station.size() < 3) {
        return core::fail(core::ErrorKind::kBadInput,
                          QCoreApplication::translate("Geometry", "A plane needs at least three points."),
                          QCoreApplication::translate("Geometry", "Measure more points on it."));
    }
    const Eigen::Matrix3Xd columns = asColumns(points_station);
    const Eigen::Vector3d centroid = columns.rowwise().mean();
    const Eigen::JacobiSVD<Eigen::Matrix3Xd> svd(columns.colwise() - centroid, Eigen::ComputeFullU);
    const auto& spread = svd.singularValues();
    if (!columns.allFinite() || !(spread(1) > kOnOneLine * spread(0))) {
        return core::fail(
            core::ErrorKind::kUndefined,
            QCoreApplication::translate("Geometry", "The points lie on one line."),
            QCoreApplication::translate("Geometry", "Measure a point to the side of that line."));
    }
    return withResiduals(facingTheStation(svd.matrixU().col(2), centroid), points_station);
}

core::Result<Eigen::Vector3d> intersect(const Ray& ray, const Plane& plane) {
    constexpr double kParallel = 1e-9;
    const double approach = plane.normal.dot(ray.direction);
    const double distance_m = -signedDistance(plane, ray.origin_m) / approach;
    if (std::abs(approach) < kParallel || !(distance_m >= 0.0)) {
        return core::fail(
            core::ErrorKind::kUndefined,
            QCoreApplication::translate("Geometry", "The line of view does not meet the plane."));
    }
    return ray.at(distance_m);
}

double signedDistance(const Plane& plane, const Eigen::Vector3d& p_station) {
    return plane.normal.dot(p_station) + plane.offset_m;
}

}  // namespace pmts::geometry
