#include "pmts/camera/lens_difference.hpp"

#include "pmts/geometry/polar.hpp"
#include "support/matchers.hpp"

namespace pmts::camera {
namespace {

using core::Angle;

constexpr BrownLens kWebcam{.f_px = 1400, .cx_px = 643.5, .cy_px = 357.5, .k1 = -0.12, .k2 = 0.02};

Rig rig() {
    return {.lens = Lens(kWebcam),
            .mount = {.kind = MountKind::kTelescope, .offset_m = {0.012, 0.085, 0.052}, .yaw = Angle::fromGon(0.15),
                      .pitch = Angle::fromGon(-0.2), .twist = Angle::fromGon(0.3)},
            .width_px = 1280, .height_px = 720};
}

TEST(LensDifferenceTest, LongerFocalLengthShowsAtTheCorners) {
    BrownLens longer{.f_px = 1414, .cx_px = 639.5, .cy_px = 359.5};
    BrownLens plain{.f_px = 1400, .cx_px = 639.5, .cy_px = 359.5};
    const auto difference = lensDifference(Lens(plain), Lens(longer), 1280, 720);
    // A corner is 733.7 px off the middle: 1 % of it.
    EXPECT_NEAR(difference->largest_px, 7.337 / 1.01, 0.02);
    EXPECT_LT(difference->rms_px, difference->largest_px);
}

TEST(LensDifferenceTest, ShiftedPrincipalPointIsMostlyATurn) {
    BrownLens shifted = kWebcam;
    shifted.cx_px += 14;
    const auto difference = lensDifference(Lens(kWebcam), Lens(shifted), 1280, 720);
    EXPECT_LT(difference->rms_px, 2.0) << "14 px without the turn";
    const double turn = std::acos(std::clamp((difference->first_from_second.trace() - 1) / 2, -1.0, 1.0));
    EXPECT_NEAR(turn, 14.0 / 1400, 0.002);
}

TEST(LensDifferenceTest, SameLensIsNoDifference) {
    EXPECT_LT(lensDifference(Lens(kWebcam), Lens(kWebcam), 1280, 720)->largest_px, 1e-5);
}

TEST(LensDifferenceTest, NewLensKeepsWhereThePixelsLookAndTheOffsets) {
    BrownLens shifted = kWebcam;
    shifted.cx_px += 2.5;
    shifted.cy_px -= 1.5;
    const auto changed = withLens(rig(), Lens(shifted));
    ASSERT_TRUE(changed.has_value());
    EXPECT_EQ(changed->mount.offset_m, rig().mount.offset_m);
    const geometry::Pointing at{Angle::fromGon(37), Angle::fromGon(88)};
    const Eigen::Vector3d p = geometry::stationFromPolar({{Angle::fromGon(44), Angle::fromGon(92)}, 15.0});
    EXPECT_LT((*pixelFromStation(*changed, at, p) - *pixelFromStation(rig(), at, p)).norm(), 0.1);
    Rig kept = rig();
    kept.lens = Lens(shifted);
    EXPECT_GT((*pixelFromStation(kept, at, p) - *pixelFromStation(rig(), at, p)).norm(), 2.0) << "angles kept as they were";
}

TEST(LensDifferenceTest, SameLensKeepsTheMountToTheLastDigits) {
    const auto same = withLens(rig(), Lens(kWebcam));
    EXPECT_NEAR(same->mount.yaw.gon(), 0.15, 1e-7);
    EXPECT_NEAR(same->mount.pitch.gon(), -0.2, 1e-7);
    EXPECT_NEAR(same->mount.twist.gon(), 0.3, 1e-7);
}

}  // namespace
}  // namespace pmts::camera
