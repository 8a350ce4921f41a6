#pragma once

#include "pmts/camera/lens.hpp"
#include "pmts/core/angle.hpp"
#include "pmts/geometry/pointing.hpp"

#include <Eigen/Core>

namespace pmts::camera {

/// What the camera is strapped to (thesis 5.4): the telescope tilts it with VA, the handle turns it with HA
/// only.
enum class MountKind { kTelescope, kHandle };

/// Where the camera sits and how it is turned against the instrument part that carries it.
/// Carrier frame: x right, y forward (the line of sight, or its horizontal projection for the handle), z up;
/// origin at the telescope's optical centre. With all angles zero the camera looks along +y, upright.
/// Order of the small rotations: yaw about z, then pitch about x, then twist about the optical axis;
/// positive yaw looks to the right, positive pitch looks up, positive twist turns the camera clockwise as
/// seen from behind.
struct Mount {
    MountKind kind = MountKind::kTelescope;
    Eigen::Vector3d offset_m = Eigen::Vector3d::Zero();  ///< (Xo, Yo, Zo): right, forward, up
    core::Angle yaw{}, pitch{}, twist{};
};

/// A camera on an instrument.
struct Rig {
    Lens lens;
    Mount mount;
    int width_px = 1280;
    int height_px = 720;
};

/// Pose of the camera in the station frame (x east at HA 100 gon, y at HA 0, z up; origin at the optical
/// centre).
///     p_station = station_from_camera * p_camera + centre_station_m
struct CameraPose {
    Eigen::Matrix3d station_from_camera = Eigen::Matrix3d::Identity();
    Eigen::Vector3d centre_station_m = Eigen::Vector3d::Zero();
};

/// Pose at these circle readings. Valid in both faces: in face II a camera on the telescope stands on its
/// head, one on the handle looks to the instrument's back.
[[nodiscard]] CameraPose cameraPose(const Mount& mount, const geometry::Pointing& pointing);

/// Pixel at which a station-frame point appears. kUndefined behind the camera; may lie outside the image.
[[nodiscard]] core::Result<Eigen::Vector2d> pixelFromStation(const Rig& rig,
                                                             const geometry::Pointing& pointing,
                                                             const Eigen::Vector3d& p_station);

}  // namespace pmts::camera
