#include "pmts/camera/rig.hpp"

#include "geometry/poses.hpp"
#include "pmts/geometry/frames.hpp"
#include "pmts/geometry/polar.hpp"
#include "support/matchers.hpp"

#include <Eigen/LU>

namespace pmts::camera {
namespace {

using core::Angle;
using geometry::Pointing;
using test::FailedWith;

Pointing pointing(double ha_gon, double va_gon) { return {Angle::fromGon(ha_gon), Angle::fromGon(va_gon)}; }

/// 1000 px of focal length, centre (640, 360), nothing turned or shifted.
Rig plainRig(MountKind kind) {
    Rig rig;
    rig.lens = Lens(BrownLens{.f_px = 1000, .cx_px = 640, .cy_px = 360});
    rig.mount.kind = kind;
    return rig;
}

Eigen::Vector2d pixel(const Rig& rig, const Pointing& at, const Eigen::Vector3d& p_station) {
    return pixelFromStation(rig, at, p_station).value();
}

TEST(RigTest, EastIsRightAndUpIsUpInAPictureTakenToTheNorth) {
    const Rig rig = plainRig(MountKind::kTelescope);
    EXPECT_TRUE(pixel(rig, pointing(0, 100), {1, 10, 0}).isApprox(Eigen::Vector2d(740, 360), 1e-12));
    EXPECT_TRUE(pixel(rig, pointing(0, 100), {0, 10, 1}).isApprox(Eigen::Vector2d(640, 260), 1e-12));
}

TEST(RigTest, TelescopeCameraTiltsWithVaAndHandleCameraDoesNot) {
    const Eigen::Vector3d half_way_up(0, 10, 10);
    EXPECT_TRUE(pixel(plainRig(MountKind::kTelescope), pointing(0, 50), half_way_up)
                    .isApprox(Eigen::Vector2d(640, 360), 1e-9));
    EXPECT_TRUE(pixel(plainRig(MountKind::kHandle), pointing(0, 50), half_way_up)
                    .isApprox(Eigen::Vector2d(640, -640), 1e-9));
}

TEST(RigTest, CameraOffsetsAreRightForwardUp) {
    Rig rig = plainRig(MountKind::kHandle);
    rig.mount.offset_m = {0.1, 0.5, 0.2};
    const CameraPose facing_east = cameraPose(rig.mount, pointing(100, 100));
    EXPECT_TRUE(facing_east.centre_station_m.isApprox(Eigen::Vector3d(0.5, -0.1, 0.2), 1e-12));
    // A point dead ahead of the camera: 0.1 m right of and 0.2 m above the telescope's axis.
    EXPECT_TRUE(pixel(rig, pointing(0, 100), {0.1, 8, 0.2}).isApprox(Eigen::Vector2d(640, 360), 1e-9));
}

TEST(RigTest, PositiveYawLooksRightPositivePitchUpPositiveTwistClockwise) {
    const Eigen::Vector3d ahead(0, 10, 0);
    Rig yawed = plainRig(MountKind::kHandle);
    yawed.mount.yaw = Angle::fromDeg(1);
    EXPECT_NEAR(pixel(yawed, pointing(0, 100), ahead).x(), 640 - 17.4551,
                1e-4);  // 1000 tan 1 deg to the left
    Rig pitched = plainRig(MountKind::kHandle);
    pitched.mount.pitch = Angle::fromDeg(1);
    EXPECT_NEAR(pixel(pitched, pointing(0, 100), ahead).y(), 360 + 17.4551, 1e-4);  // lower in the picture
    Rig twisted = plainRig(MountKind::kHandle);
    twisted.mount.twist = Angle::fromDeg(90);
    // The camera lies on its right side: what is above now appears at the left.
    EXPECT_TRUE(pixel(twisted, pointing(0, 100), {0, 10, 1}).isApprox(Eigen::Vector2d(540, 360), 1e-9));
}

TEST(RigTest, SmallRotationsAreAppliedYawThenPitchThenTwist) {
    // Yaw 90 deg looks right (east); pitch 90 deg from there looks straight up; twist turns about that axis.
    Mount mount{.kind = MountKind::kHandle, .yaw = Angle::fromDeg(90), .pitch = Angle::fromDeg(90)};
    const CameraPose pose = cameraPose(mount, pointing(0, 100));
    EXPECT_TRUE(pose.station_from_camera.col(2).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
    EXPECT_TRUE(pose.station_from_camera.col(0).isApprox(-Eigen::Vector3d::UnitY(), 1e-12));
    mount.twist = Angle::fromDeg(30);
    EXPECT_TRUE(cameraPose(mount, pointing(0, 100))
                    .station_from_camera.col(2)
                    .isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
}

TEST(RigTest, FaceTwoTurnsTheTelescopesPictureUpsideDown) {
    const Rig rig = plainRig(MountKind::kTelescope);
    const Eigen::Vector3d upper_right(1, 10, 2);
    EXPECT_TRUE(pixel(rig, pointing(0, 100), upper_right).isApprox(Eigen::Vector2d(740, 160), 1e-9));
    EXPECT_TRUE(pixel(rig, pointing(200, 300), upper_right).isApprox(Eigen::Vector2d(540, 560), 1e-9));
}

TEST(RigTest, FaceTwoTurnsTheHandleCameraAway) {
    const Rig rig = plainRig(MountKind::kHandle);
    EXPECT_THAT(pixelFromStation(rig, pointing(200, 300), {0, 10, 0}),
                FailedWith(core::ErrorKind::kUndefined));
    EXPECT_TRUE(pixelFromStation(rig, pointing(0, 300), {0, 10, 0}).has_value());
}

TEST(RigTest, PoseIsARightHandedRotationWhoseCentreKeepsItsDistance) {
    test::RandomPoses poses(21);
    for (int i = 0; i < 200; ++i) {
        const Mount mount{.kind = i % 2 == 0 ? MountKind::kTelescope : MountKind::kHandle,
                          .offset_m = poses.inBox(0.3),
                          .yaw = Angle::fromGon(poses.uniform(-5, 5)),
                          .pitch = Angle::fromGon(poses.uniform(-5, 5)),
                          .twist = Angle::fromGon(poses.uniform(-5, 5))};
        const CameraPose pose = cameraPose(mount, poses.eitherFace());
        EXPECT_NEAR(pose.station_from_camera.determinant(), 1.0, 1e-12);
        EXPECT_NEAR(pose.centre_station_m.norm(), mount.offset_m.norm(), 1e-12);
    }
}

TEST(RigTest, PixelRayPassesThroughThePointThatWasSeen) {
    test::RandomPoses poses(22);
    Rig rig = plainRig(MountKind::kTelescope);
    rig.mount = {.kind = MountKind::kTelescope,
                 .offset_m = {0.02, 0.1, 0.15},
                 .yaw = Angle::fromGon(0.4),
                 .pitch = Angle::fromGon(-0.8),
                 .twist = Angle::fromGon(1.1)};
    for (int i = 0; i < 200; ++i) {
        const Pointing at = poses.eitherFace();
        const Eigen::Vector3d near_axis(poses.uniform(-3, 3), 10, poses.uniform(-2, 2));
        const Eigen::Vector3d p_station = geometry::stationFromTelescope(at) * near_axis;
        const auto ray = rig.lens.cameraFromPixel(pixel(rig, at, p_station));
        const CameraPose pose = cameraPose(rig.mount, at);
        const Eigen::Vector3d towards = (p_station - pose.centre_station_m).normalized();
        EXPECT_LT((pose.station_from_camera * *ray - towards).norm(), 1e-9);
    }
}

}  // namespace
}  // namespace pmts::camera
