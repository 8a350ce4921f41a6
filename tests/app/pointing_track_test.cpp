#include "pmts/app/desk/pointing_track.hpp"

#include "support/matchers.hpp"

namespace pmts::app {
namespace {

using namespace std::chrono_literals;
using core::Angle;
using test::IsNearAngle;

TimedPointing reading(double ha_gon, double va_gon, core::Duration at) {
    return {.pointing = {.ha = Angle::fromGon(ha_gon), .va = Angle::fromGon(va_gon)}, .at = at};
}

TEST(PointingTrackTest, KnowsNothingBeforeTheFirstReading) {
    EXPECT_FALSE(PointingTrack{}.at(1s).has_value());
    EXPECT_FALSE(PointingTrack{}.newest().has_value());
}

TEST(PointingTrackTest, BetweenTwoReadingsTheShortWayRoundIsTaken) {
    PointingTrack track;
    track.add(reading(399, 100, 1s));
    track.add(reading(1, 102, 2s));
    const auto halfway = track.at(1500ms);
    ASSERT_TRUE(halfway.has_value());
    EXPECT_THAT(halfway->pointing.ha, IsNearAngle(Angle::fromGon(0), Angle::fromCc(0.1)));
    EXPECT_THAT(halfway->pointing.va, IsNearAngle(Angle::fromGon(101), Angle::fromCc(0.1)));
    EXPECT_TRUE(halfway->moving);
    EXPECT_FALSE(halfway->settled);
}

TEST(PointingTrackTest, EqualReadingsOnBothSidesOfAFrameSettleIt) {
    PointingTrack track;
    track.add(reading(50, 100, 1s));
    track.add(reading(50.0004, 99.9997, 2s));  // noise of the circles: 4 cc
    EXPECT_TRUE(track.at(1200ms)->settled);
    EXPECT_FALSE(track.at(2100ms)->settled) << "no reading says yet that it still stands";
}

TEST(PointingTrackTest, FrameAfterTheLastReadingOfATurnIsMoving) {
    PointingTrack track;
    track.add(reading(50, 100, 1s));
    track.add(reading(55, 100, 2s));
    EXPECT_TRUE(track.at(2050ms)->moving);
}

TEST(PointingTrackTest, LateReadingOfAnOlderMomentIsIgnored) {
    PointingTrack track;
    track.add(reading(50, 100, 2s));
    track.add(reading(40, 100, 1s));
    EXPECT_EQ(track.newest()->pointing.ha.gon(), 50.0);
}

TEST(PointingTrackTest, OldReadingsAreForgotten) {
    PointingTrack track;
    for (int i = 0; i < 100; ++i) {
        track.add(reading(i, 100, i * 100ms));
    }
    EXPECT_THAT(track.at(0s)->pointing.ha, IsNearAngle(Angle::fromGon(69), Angle::fromGon(1)));
}

}  // namespace
}  // namespace pmts::app
