#include "pmts/survey/station.hpp"

#include "support/matchers.hpp"

namespace pmts::survey {
namespace {

using core::Angle;
using test::IsNearAngle;

TEST(StationTest, StartsWithTheThesissDefaults) {
    const Station station;
    EXPECT_EQ(station.e_m, 1000.0);
    EXPECT_EQ(station.n_m, 1000.0);
    EXPECT_EQ(station.h_m, 100.0);
}

TEST(StationTest, BearingGrowsClockwiseFromNorth) {
    // Protocol page, DEMO1.JOB: reference 101 lies 100 m north and 100 m east of station 100, HAref = 50 gon.
    const Station station{.e_m = 2000, .n_m = 1000, .h_m = 50};
    EXPECT_THAT(bearingTo(station, 2100, 1100), IsNearAngle(Angle::fromGon(50), Angle::fromCc(0.01)));
    EXPECT_THAT(bearingTo(station, 2000, 1010), IsNearAngle(Angle::fromGon(0), Angle::fromCc(0.01)));
    EXPECT_THAT(bearingTo(station, 2010, 1000), IsNearAngle(Angle::fromGon(100), Angle::fromCc(0.01)));
    EXPECT_NEAR(bearingTo(station, 1990, 1000).gon(), 300.0, 1e-9);
}

TEST(StationTest, OrientationTurnsTheCircleReadingIntoTheBearing) {
    EXPECT_THAT(orientationFor(Angle::fromGon(10), Angle::fromGon(50)),
                IsNearAngle(Angle::fromGon(40), Angle::fromCc(0.01)));
    EXPECT_NEAR(orientationFor(Angle::fromGon(390), Angle::fromGon(10)).gon(), 20.0, 1e-9);
    EXPECT_NEAR(orientationFor(Angle::fromGon(10), Angle::fromGon(390)).gon(), 380.0, 1e-9);
}

}  // namespace
}  // namespace pmts::survey
