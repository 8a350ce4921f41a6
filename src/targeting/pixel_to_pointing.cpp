#include "pmts/targeting/pixel_to_pointing.hpp"

#include "pmts/geometry/polar.hpp"

#include <QCoreApplication>

#include <cmath>

namespace pmts::targeting {

core::Result<geometry::Ray> PixelToPointing::rayForPixel(const Eigen::Vector2d& px,
                                                         const geometry::Pointing& at) const {
    const camera::CameraPose pose = camera::cameraPose(rig_.mount, at);
    return rig_.lens.cameraFromPixel(px).map([&pose](const Eigen::Vector3d& ray_camera) {
        return geometry::Ray{.origin_m = pose.centre_station_m,
                             .direction = pose.station_from_camera * ray_camera};
    });
}

core::Result<geometry::Pointing> PixelToPointing::pointingForPixel(const Eigen::Vector2d& px,
                                                                   const geometry::Pointing& at,
                                                                   double slope_distance_m) const {
    const auto ray = rayForPixel(px, at);
    PMTS_TRY(ray);
    const auto p_station = geometry::intersectSphere(*ray, slope_distance_m);
    PMTS_TRY(p_station);
    return geometry::polarFromStation(*p_station).map([](const geometry::PolarPoint& polar) {
        return polar.pointing;
    });
}

core::Result<Eigen::Vector2d> PixelToPointing::reticlePixel(const geometry::Pointing& at,
                                                            double slope_distance_m) const {
    if (!(slope_distance_m > 0) || !std::isfinite(slope_distance_m)) {
        return core::fail(core::ErrorKind::kUndefined,
                          QCoreApplication::translate("Targeting", "The reticle needs a distance."),
                          QCoreApplication::translate("Targeting", "Measure or enter one."));
    }
    return pixelForPoint(geometry::stationFromPolar({at, slope_distance_m}), at);
}

core::Result<Eigen::Vector2d> PixelToPointing::pixelForPoint(const Eigen::Vector3d& p_station,
                                                             const geometry::Pointing& at) const {
    return camera::pixelFromStation(rig_, at, p_station);
}

}  // namespace pmts::targeting
