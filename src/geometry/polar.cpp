#include "pmts/geometry/polar.hpp"

#include "pmts/geometry/frames.hpp"

#include <Eigen/Geometry>
#include <QCoreApplication>

#include <cmath>

namespace pmts::geometry {

Eigen::Vector3d stationFromPolar(const PolarPoint& observed) {
    return observed.slope_distance_m * directionFromPointing(observed.pointing);
}

core::Result<PolarPoint> polarFromStation(const Eigen::Vector3d& p_station) {
    constexpr double kPlumbLine_m = 1e-6;
    const double level_m = std::hypot(p_station.x(), p_station.y());
    if (!p_station.allFinite() || level_m < kPlumbLine_m) {
        return core::fail(
            core::ErrorKind::kUndefined,
            QCoreApplication::translate("Geometry", "The point is on the instrument's vertical axis."),
            QCoreApplication::translate("Geometry", "Choose a point away from the vertical axis."));
    }
    const auto ha = core::Angle::fromRad(std::atan2(p_station.x(), p_station.y()));
    return PolarPoint{.pointing = {.ha = core::normalized(ha),
                                   .va = core::Angle::fromRad(std::atan2(level_m, p_station.z()))},
                      .slope_distance_m = p_station.norm()};
}

Pointing otherFace(const Pointing& pointing) {
    return {.ha = core::normalized(pointing.ha + core::Angle::fromGon(200)),
            .va = core::normalized(core::Angle::fromGon(400) - pointing.va)};
}

bool isFaceTwo(const Pointing& pointing) { return core::normalized(pointing.va) > core::Angle::fromGon(200); }

core::Angle separation(const Pointing& a, const Pointing& b) {
    // The arc cosine of the dot product would lose half the digits of a small angle.
    const Eigen::Vector3d to_a = directionFromPointing(a);
    const Eigen::Vector3d to_b = directionFromPointing(b);
    return core::Angle::fromRad(std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b)));
}

Pointing inFaceOf(const Pointing& reference, const Pointing& target) {
    return isFaceTwo(reference) == isFaceTwo(target) ? target : otherFace(target);
}

}  // namespace pmts::geometry
