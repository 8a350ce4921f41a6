#include "pmts/camera/rig.hpp"

#include "pmts/geometry/frames.hpp"

#include <Eigen/Geometry>

namespace pmts::camera {
namespace {

Eigen::Matrix3d carrierFromCamera(const Mount& mount) {
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    Eigen::Matrix3d
        carrier_from_upright;         // camera x right, y down, z forward -> carrier x right, y forward, z up
    carrier_from_upright << 1, 0, 0,  //
        0, 0, 1,                      //
        0, -1, 0;
    return AngleAxisd(-mount.yaw.rad(), Vector3d::UnitZ()) *
           AngleAxisd(mount.pitch.rad(), Vector3d::UnitX()) *
           AngleAxisd(mount.twist.rad(), Vector3d::UnitY()) * carrier_from_upright;
}

}  // namespace

CameraPose cameraPose(const Mount& mount, const geometry::Pointing& pointing) {
    const Eigen::Matrix3d station_from_carrier = mount.kind == MountKind::kTelescope
                                                     ? geometry::stationFromTelescope(pointing)
                                                     : geometry::stationFromAlidade(pointing.ha);
    return {.station_from_camera = station_from_carrier * carrierFromCamera(mount),
            .centre_station_m = station_from_carrier * mount.offset_m};
}

core::Result<Eigen::Vector2d> pixelFromStation(const Rig& rig, const geometry::Pointing& pointing,
                                               const Eigen::Vector3d& p_station) {
    const CameraPose pose = cameraPose(rig.mount, pointing);
    return rig.lens.pixelFromCamera(pose.station_from_camera.transpose() *
                                    (p_station - pose.centre_station_m));
}

}  // namespace pmts::camera
