#include "pmts/geometry/polar.hpp"

#include "geometry/poses.hpp"
#include "support/matchers.hpp"

namespace pmts::geometry {
namespace {

using core::Angle;
using test::FailedWith;
using test::IsNearAngle;

Pointing pointing(double ha_gon, double va_gon) { return {Angle::fromGon(ha_gon), Angle::fromGon(va_gon)}; }

TEST(PolarTest, HaGrowsClockwiseFromNorthAndVaFromTheZenith) {
    // The compass fixes these: north is y, a quarter turn clockwise is east, 50 gon from the zenith is half
    // way up.
    EXPECT_TRUE(stationFromPolar({pointing(0, 100), 10.0}).isApprox(Eigen::Vector3d(0, 10, 0), 1e-12));
    EXPECT_TRUE(stationFromPolar({pointing(100, 100), 10.0}).isApprox(Eigen::Vector3d(10, 0, 0), 1e-12));
    EXPECT_TRUE(stationFromPolar({pointing(50, 100), 10.0})
                    .isApprox(Eigen::Vector3d(7.0710678118655, 7.0710678118655, 0), 1e-12));
    EXPECT_TRUE(stationFromPolar({pointing(300, 50), 2.0})
                    .isApprox(Eigen::Vector3d(-1.4142135623731, 0, 1.4142135623731), 1e-12));
}

TEST(PolarTest, PanelReadingOfTheCaptureGivesItsPointByPlainTrigonometry) {
    // HA 159 deg 48' 18.126", VA 86 deg 33' 5.5512" (thesis 3.5), 25.4 m; worked out with a pocket
    // calculator's sines.
    const Eigen::Vector3d p_station = stationFromPolar({pointing(177.56115, 96.16838), 25.4});
    EXPECT_NEAR(p_station.x(), 8.752602, 1e-6);
    EXPECT_NEAR(p_station.y(), -23.795329, 1e-6);
    EXPECT_NEAR(p_station.z(), 1.527826, 1e-6);
}

TEST(PolarTest, BothFacesOfAPointingGiveTheSamePoint) {
    test::RandomPoses poses(2);
    for (int i = 0; i < 200; ++i) {
        const Pointing face_one = poses.faceOne();
        const double sd_m = poses.uniform(0.5, 10000);
        const Pointing face_two = otherFace(face_one);
        EXPECT_TRUE(isFaceTwo(face_two));
        EXPECT_LT((stationFromPolar({face_one, sd_m}) - stationFromPolar({face_two, sd_m})).norm(), 1e-9);
    }
}

TEST(PolarTest, TargetIsTakenInTheFaceOfTheReference) {
    const Pointing target = pointing(30, 80);
    EXPECT_EQ(inFaceOf(pointing(10, 100), target), target);
    const Pointing turned = inFaceOf(pointing(210, 300), target);
    EXPECT_THAT(turned.ha, IsNearAngle(Angle::fromGon(230), Angle::fromCc(0.001)));
    EXPECT_THAT(turned.va, IsNearAngle(Angle::fromGon(320), Angle::fromCc(0.001)));
    EXPECT_EQ(inFaceOf(pointing(210, 300), turned), turned);
}

TEST(PolarTest, PointGoesBackToTheFaceOneReadingsItWasMeasuredAt) {
    test::RandomPoses poses(3);
    for (int i = 0; i < 200; ++i) {
        const PolarPoint observed{poses.faceOne(), poses.uniform(0.5, 10000)};
        const auto again = polarFromStation(stationFromPolar(observed));
        ASSERT_TRUE(again.has_value());
        EXPECT_THAT(again->pointing.ha, IsNearAngle(observed.pointing.ha, Angle::fromCc(0.001)));
        EXPECT_THAT(again->pointing.va, IsNearAngle(observed.pointing.va, Angle::fromCc(0.001)));
        EXPECT_NEAR(again->slope_distance_m, observed.slope_distance_m, 1e-9);
        EXPECT_LT((stationFromPolar(*again) - stationFromPolar(observed)).norm(), 1e-9);
    }
}

TEST(PolarTest, FaceTwoReadingIsReportedAsItsFaceOneTwin) {
    const auto polar = polarFromStation(stationFromPolar({pointing(250, 290), 12.0}));
    ASSERT_TRUE(polar.has_value());
    EXPECT_THAT(polar->pointing.ha, IsNearAngle(Angle::fromGon(50), Angle::fromCc(0.001)));
    EXPECT_THAT(polar->pointing.va, IsNearAngle(Angle::fromGon(110), Angle::fromCc(0.001)));
}

TEST(PolarTest, PointOnTheVerticalAxisHasNoPointing) {
    EXPECT_THAT(polarFromStation({0, 0, 5}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(polarFromStation({5e-7, 0, -2}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_TRUE(polarFromStation({2e-6, 0, -2}).has_value());
    EXPECT_THAT(polarFromStation({std::nan(""), 1, 0}), FailedWith(core::ErrorKind::kUndefined));
}

TEST(PolarTest, SeparationOfOneCcKeepsItsDigits) {
    EXPECT_NEAR(separation(pointing(10, 100), pointing(10.0001, 100)).cc(), 1.0, 0.001);
    EXPECT_NEAR(separation(pointing(399.99995, 100), pointing(0.00005, 100)).cc(), 1.0, 0.001);
    EXPECT_NEAR(separation(pointing(10, 50), pointing(10, 50.0001)).cc(), 1.0, 0.001);
}

TEST(PolarTest, SeparationIsTheAngleOnTheSphere) {
    // A quarter turn of HA at 45 degrees elevation is 60 degrees on the sphere.
    EXPECT_NEAR(separation(pointing(0, 50), pointing(100, 50)).deg(), 60.0, 1e-10);
    EXPECT_NEAR(separation(pointing(0, 100), pointing(200, 100)).gon(), 200.0, 1e-9);
    EXPECT_NEAR(separation(pointing(30, 80), otherFace(pointing(30, 80))).cc(), 0.0, 0.001);
}

}  // namespace
}  // namespace pmts::geometry
