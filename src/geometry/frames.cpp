#include "pmts/geometry/frames.hpp"

#include <QCoreApplication>

#include <cmath>

namespace pmts::geometry {

Eigen::Matrix3d stationFromAlidade(core::Angle ha) {
    const double s = core::sin(ha);
    const double c = core::cos(ha);
    Eigen::Matrix3d station_from_alidade;
    station_from_alidade << c, s, 0,  //
        -s, c, 0,                     //
        0, 0, 1;
    return station_from_alidade;
}

Eigen::Matrix3d stationFromTelescope(const Pointing& pointing) {
    const double s = core::sin(pointing.va);
    const double c = core::cos(pointing.va);
    Eigen::Matrix3d alidade_from_telescope;  // a turn about x by the elevation, 100 gon - VA
    alidade_from_telescope << 1, 0, 0,       //
        0, s, -c,                            //
        0, c, s;
    return stationFromAlidade(pointing.ha) * alidade_from_telescope;
}

Eigen::Vector3d directionFromPointing(const Pointing& pointing) {
    const double level = core::sin(pointing.va);
    return {level * core::sin(pointing.ha), level * core::cos(pointing.ha), core::cos(pointing.va)};
}

core::Result<Pointing> pointingFromDirection(const Eigen::Vector3d& direction_station) {
    const double level = std::hypot(direction_station.x(), direction_station.y());
    const double zenith_rad = std::atan2(level, direction_station.z());
    if (!direction_station.allFinite() || level <= 1e-9 * direction_station.norm()) {
        return core::fail(
            core::ErrorKind::kUndefined,
            QCoreApplication::translate("Geometry", "The direction is straight up or down."),
            QCoreApplication::translate("Geometry", "Choose a target away from the vertical axis."));
    }
    return Pointing{.ha = core::normalized(
                        core::Angle::fromRad(std::atan2(direction_station.x(), direction_station.y()))),
                    .va = core::Angle::fromRad(zenith_rad)};
}

}  // namespace pmts::geometry
