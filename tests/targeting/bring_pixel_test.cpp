#include "pmts/targeting/bring_pixel.hpp"

#include "pmts/geometry/polar.hpp"
#include "support/matchers.hpp"

namespace pmts::targeting {
namespace {

using camera::MountKind;
using core::Angle;
using geometry::Pointing;
using test::IsNearAngle;

Pointing pointing(double ha_gon, double va_gon) { return {Angle::fromGon(ha_gon), Angle::fromGon(va_gon)}; }

PixelToPointing model(MountKind kind) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1000, .cx_px = 640, .cy_px = 360, .k1 = -0.1});
    rig.mount = {.kind = kind, .offset_m = {0.02, 0, 0.1}, .twist = Angle::fromGon(1.5)};
    return PixelToPointing(rig);
}

class BringPixelTest : public testing::TestWithParam<Pointing> {};

TEST_P(BringPixelTest, GrabbedSpotAppearsWhereItWasReleased) {
    const PixelToPointing view = model(MountKind::kTelescope);
    const Eigen::Vector2d grabbed(250, 520), released(900, 180);
    const auto next = pointingToBring(view, grabbed, released, GetParam(), 12.0);
    ASSERT_TRUE(next.has_value()) << next.error().sentence().toStdString();
    // The spot itself, seen from the new pointing.
    const auto spot = geometry::intersectSphere(*view.rayForPixel(grabbed, GetParam()), 12.0);
    const auto seen = view.pixelForPoint(*spot, *next);
    EXPECT_NEAR((*seen - released).norm(), 0.0, 0.01);
    EXPECT_EQ(geometry::isFaceTwo(*next), geometry::isFaceTwo(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(LevelSteepAndFaceTwo, BringPixelTest,
                         testing::Values(pointing(10, 100), pointing(399.9, 55), pointing(120, 140), pointing(300, 295)));

TEST(BringPixelTest, ReleasedOnTheReticleTheAxisMeetsTheSpot) {
    const PixelToPointing view = model(MountKind::kTelescope);
    const Pointing at = pointing(30, 70);
    const Eigen::Vector2d grabbed(300, 500);
    const auto next = pointingToBring(view, grabbed, *view.reticlePixel(at, 20.0), at, 20.0);
    const auto aimed = view.pointingForPixel(grabbed, at, 20.0);
    ASSERT_TRUE(next && aimed);
    // The reticle stays at its pixel for a camera on the telescope: both ask for the same pointing.
    EXPECT_THAT(next->ha, IsNearAngle(aimed->ha, Angle::fromCc(0.5)));
    EXPECT_THAT(next->va, IsNearAngle(aimed->va, Angle::fromCc(0.5)));
}

TEST(BringPixelTest, CameraOnTheHandleDoesNotTiltWithTheTelescopeAndSaysSo) {
    const auto next = pointingToBring(model(MountKind::kHandle), {300, 500}, {300, 200}, pointing(30, 95), 20.0);
    EXPECT_THAT(next, test::FailedWith(core::ErrorKind::kUndefined));
}

}  // namespace
}  // namespace pmts::targeting
