#include "pmts/app/field/parallax_curve.hpp"

#include <gmock/gmock.h>

namespace pmts::app {
namespace {

using core::Angle;

/// 1000 px, 10 cm above the telescope: the reticle is 100 px / d[m] below the centre.
targeting::PixelToPointing plainModel(camera::MountKind kind = camera::MountKind::kTelescope) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1000, .cx_px = 640, .cy_px = 360});
    rig.mount = {.kind = kind, .offset_m = {0, 0, 0.1}};
    return targeting::PixelToPointing(rig);
}

const geometry::Pointing kLevel{.ha = Angle::fromGon(30), .va = Angle::fromGon(100)};

TEST(ParallaxCurveTest, RunsFromTheNearReticleToTheFarOne) {
    const ParallaxCurve curve = parallaxCurve(plainModel(), kLevel, 2.0, 200.0, 25.0, {});
    ASSERT_GT(curve.px.size(), 10U);
    EXPECT_NEAR(curve.px.front().y(), 360 + 50.0, 1e-6);
    EXPECT_NEAR(curve.px.back().y(), 360 + 0.5, 1e-6);
    EXPECT_NEAR(curve.px[16].y(), 360 + 25.25, 1e-6);  // half way in 1/d is half way in the picture
}

TEST(ParallaxCurveTest, NearFarAndTheRangeInUseAreMarkedWithTheirLengths) {
    const ParallaxCurve curve = parallaxCurve(plainModel(), kLevel, 2.5, 200.0, 25.0, {});
    ASSERT_EQ(curve.marks.size(), 3U);
    EXPECT_EQ(curve.marks[0].label, QStringLiteral("2.5 m"));
    EXPECT_EQ(curve.marks[1].label, QStringLiteral("200 m"));
    EXPECT_EQ(curve.marks[2].label, QStringLiteral("25 m"));
    EXPECT_NEAR(curve.marks[2].px.y(), 360 + 4.0, 1e-6);
}

TEST(ParallaxCurveTest, LengthsAreInTheSurveyorsUnit) {
    UnitFormat feet;
    feet.length_unit = LengthUnit::kFoot;
    EXPECT_EQ(shortRangeText(25.0, feet), QStringLiteral("82 ft"));
    EXPECT_EQ(shortRangeText(2.0, feet), QStringLiteral("6.6 ft"));
}

TEST(ParallaxCurveTest, WhatTheCameraCannotSeeIsLeftOut) {
    // A camera on the handle looks the other way in face II.
    const geometry::Pointing face_two{.ha = Angle::fromGon(30), .va = Angle::fromGon(300)};
    const ParallaxCurve curve =
        parallaxCurve(plainModel(camera::MountKind::kHandle), face_two, 2.0, 200.0, 25.0, {});
    EXPECT_TRUE(curve.px.empty());
    EXPECT_TRUE(curve.marks.empty());
}

}  // namespace
}  // namespace pmts::app
