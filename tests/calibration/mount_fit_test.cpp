#include "pmts/calibration/mount_fit.hpp"

#include "support/matchers.hpp"

namespace pmts::calibration {
namespace {

using camera::MountKind;
using core::Angle;
using core::ErrorKind;
using test::FailedWith;
using test::IsNearAngle;

camera::Rig rigAt(const Eigen::Vector3d& offset_m, MountKind kind = MountKind::kTelescope) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1400, .cx_px = 643.5, .cy_px = 357.5, .k1 = -0.12});
    rig.mount = {.kind = kind, .offset_m = offset_m, .yaw = Angle::fromGon(0.4), .pitch = Angle::fromGon(-0.6),
                 .twist = Angle::fromGon(0.3)};
    return rig;
}

/// The telescope on a spot, `aside_gon` more for one away from the cross-hair.
Sighting sight(const camera::Rig& truth, double distance_m, double va_gon = 100, double aside_gon = 0) {
    const geometry::PolarPoint target{{Angle::fromGon(10), Angle::fromGon(va_gon)}, distance_m};
    const geometry::Pointing at{Angle::fromGon(10 + aside_gon), Angle::fromGon(va_gon)};
    return {.px = camera::pixelFromStation(truth, at, geometry::stationFromPolar(target)).value(), .at = at, .target = target};
}

/// What somebody knows before: lens and twist, no small angle, no offset.
camera::Rig known(const camera::Rig& truth) {
    camera::Rig rig = truth;
    rig.mount.yaw = rig.mount.pitch = Angle();
    rig.mount.offset_m.setZero();
    return rig;
}

TEST(MountFitTest, GapOnTheNearBoardIsHalfTheOffset) {
    const camera::Rig truth = rigAt({0.040, 0.0, 0.052});

    const auto gap = gapAtNearBoard(known(truth), sight(truth, 8), sight(truth, 4));

    ASSERT_TRUE(gap.has_value());
    EXPECT_NEAR(gap->gap_m.x(), 0.020, 2e-4);  // the camera's small rotations are not known: second order
    EXPECT_NEAR(gap->gap_m.y(), 0.026, 2e-4);
    EXPECT_NEAR(gap->offset_m.x(), 0.040, 4e-4);
    EXPECT_NEAR(gap->offset_m.y(), 0.052, 4e-4);
}

TEST(MountFitTest, FarBoardTooNearIsRefused) {
    const camera::Rig truth = rigAt({0.040, 0.0, 0.052});

    EXPECT_THAT(gapAtNearBoard(truth, sight(truth, 5), sight(truth, 4)), FailedWith(ErrorKind::kBadInput));
}

TEST(MountFitTest, TwoBoardsGiveOffsetYawAndPitchOnBothMounts) {
    for (const MountKind kind : {MountKind::kTelescope, MountKind::kHandle}) {
        const camera::Rig truth = rigAt({0.012, 0.0, 0.052}, kind);

        const auto fit = fitMount({sight(truth, 8.1), sight(truth, 3.9)}, known(truth), {.x = true, .y = false, .z = true});

        ASSERT_TRUE(fit.has_value()) << testing::PrintToString(fit.error());
        EXPECT_NEAR((fit->mount.offset_m - truth.mount.offset_m).norm(), 0, 1e-6);
        EXPECT_THAT(fit->mount.yaw, IsNearAngle(truth.mount.yaw, Angle::fromMgon(0.1)));
        EXPECT_THAT(fit->mount.pitch, IsNearAngle(truth.mount.pitch, Angle::fromMgon(0.1)));
    }
}

TEST(MountFitTest, EveryOffsetCaseKeepsTheOthersAtZero) {
    for (int number = 0; number < 8; ++number) {
        const OffsetCase sought{.x = (number & 1) != 0, .y = (number & 2) != 0, .z = (number & 4) != 0};
        const camera::Rig truth = rigAt({sought.x ? 0.02 : 0.0, sought.y ? 0.085 : 0.0, sought.z ? -0.04 : 0.0});

        const auto fit = fitMount({sight(truth, 8), sight(truth, 4), sight(truth, 4, 100, 15), sight(truth, 4, 100, -15)},
                                  known(truth), sought);

        ASSERT_TRUE(fit.has_value()) << number << ": " << testing::PrintToString(fit.error());
        EXPECT_NEAR((fit->mount.offset_m - truth.mount.offset_m).norm(), 0, 1e-5) << number;
        EXPECT_EQ(fit->offset_sigma_m[0].has_value(), sought.x);
        EXPECT_EQ(fit->offset_sigma_m[1].has_value(), sought.y);
    }
}

TEST(MountFitTest, OneDistanceDoesNotTellOffsetFromDirection) {
    const camera::Rig truth = rigAt({0.02, 0.0, 0.04});

    EXPECT_THAT(fitMount({sight(truth, 4), sight(truth, 4)}, known(truth), {}), FailedWith(ErrorKind::kUndefined));
}

TEST(MountFitTest, ForwardOffsetWantsASightingAside) {
    const camera::Rig truth = rigAt({0.0, 0.085, 0.0});

    EXPECT_THAT(fitMount({sight(truth, 8), sight(truth, 4)}, known(truth), {.x = false, .y = true, .z = false}),
                FailedWith(ErrorKind::kUndefined));
}

TEST(MountFitTest, NearBoardHangsBeyondTheCloseLimitAndWhereAPixelIsSmallerThanTheOffset) {
    const NearBoardRange range = nearBoardRange({.telescope_close_m = 1.7, .camera_close_m = 0.5, .offset_m = 0.02}, 1400);

    EXPECT_DOUBLE_EQ(range.least_m, 1.7);
    EXPECT_DOUBLE_EQ(range.most_m, 28.0);  // there a pixel is 2 cm wide
    EXPECT_TRUE(range.holds(4.0));
    EXPECT_FALSE(range.holds(1.5));
    EXPECT_FALSE(range.holds(30.0));
}

}  // namespace
}  // namespace pmts::calibration
