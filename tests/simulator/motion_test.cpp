#include "pmts/simulator/world.hpp"
#include "support/matchers.hpp"

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;
using core::Angle;
using test::IsNearAngle;

double asSeconds(core::Duration span) { return std::chrono::duration<double>(span).count(); }

TEST(AxisMotionTest, LongWayTakesRampsAndCruise) {
    // 0 -> 100 gon at 50 gon/s and 100 gon/s2: 0.5 s up, 0.5 s down, 75 gon between at full speed in 1.5 s.
    const AxisMotion motion{.start_gon = 0, .end_gon = 100};
    EXPECT_NEAR(asSeconds(motion.duration()), 2.5, 1e-8);
    EXPECT_NEAR(motion.positionGon(500ms), 12.5, 1e-9);
    EXPECT_NEAR(motion.positionGon(2s), 87.5, 1e-9);
    EXPECT_NEAR(motion.speedGonS(1s), 50.0, 1e-9);
}

TEST(AxisMotionTest, ShortWayNeverReachesFullSpeed) {
    const AxisMotion motion{.start_gon = 10, .end_gon = 9};
    EXPECT_NEAR(asSeconds(motion.duration()), 0.2, 1e-8);  // 2 sqrt(way / acceleration)
    EXPECT_NEAR(motion.positionGon(100ms), 9.5, 1e-9);
    EXPECT_NEAR(motion.speedGonS(100ms), -10.0, 1e-6);
}

TEST(AxisMotionTest, StandsBeforeAndAfter) {
    const AxisMotion motion{.start_gon = 10, .end_gon = 20, .started_at = 1s};
    EXPECT_EQ(motion.positionGon(0s), 10.0);
    EXPECT_EQ(motion.positionGon(1h), 20.0);
    EXPECT_EQ(motion.speedGonS(1h), 0.0);
}

TEST(AxisMotionTest, BrakingAxisGoesOnWithoutAJump) {
    const AxisMotion motion{.start_gon = 0, .end_gon = -100};
    const AxisMotion braking = motion.brakedAt(1s);
    EXPECT_NEAR(braking.positionGon(1s), motion.positionGon(1s), 1e-9);
    EXPECT_NEAR(braking.speedGonS(1001ms), -49.9, 1e-3);
    EXPECT_NEAR(braking.end_gon, motion.positionGon(1s) - 12.5, 1e-9);  // 50 gon/s at 100 gon/s2
    EXPECT_NEAR(asSeconds(braking.duration()), 0.5, 1e-8);
}

TEST(AxisMotionTest, AxisThatStandsStillBrakesToNothing) {
    const AxisMotion braking = AxisMotion{.start_gon = 5, .end_gon = 5}.brakedAt(3s);
    EXPECT_EQ(braking.duration(), 0s);
    EXPECT_EQ(braking.positionGon(1h), 5.0);
}

TEST(TruePointingTest, CirclesReadFromZeroToFourHundred) {
    TruePointing pointing;
    pointing.setMotion({.start_gon = 390, .end_gon = 410}, {.start_gon = 100, .end_gon = -100});
    EXPECT_THAT(pointing.at(1h).ha, IsNearAngle(Angle::fromGon(10), Angle::fromCc(0.01)));
    EXPECT_NEAR(pointing.at(1h).va.gon(), 300.0, 1e-9);  // face II
}

TEST(TruePointingTest, PlacedInFaceTwoItStaysThere) {
    TruePointing pointing;
    pointing.place({Angle::fromGon(250), Angle::fromGon(301)});
    EXPECT_NEAR(pointing.at(5s).va.gon(), 301.0, 1e-9);
    EXPECT_NEAR(pointing.motions().va.end_gon, -99.0, 1e-9);
}

}  // namespace
}  // namespace pmts::simulator
