#include "app/field_fixture.hpp"

namespace pmts::app {
namespace {

using test::IsNearAngle;

/// Limits, Sun and cable as the surveyor meets them.
class GuardedMoveTest : public FieldTest {
protected:
    void SetUp() override { connectInstrument(); }
    void set(const std::function<void(AimingSettings&)>& change) {
        Settings next = preferences.settings();
        change(next.aiming);
        preferences.set(next);
    }
};

TEST_F(GuardedMoveTest, MoveOutsideTheSectorIsRefusedWithItsReason) {
    set([](AimingSettings& aiming) { aiming.limits.ha_sector = std::pair(Angle::fromGon(350), Angle::fromGon(50)); });
    sent.clear();
    ASSERT_TRUE(turnTo(120, 95));
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("outside the sector"));
    EXPECT_THAT(sent, testing::Not(testing::HasSubstr("WS=")));
    ASSERT_TRUE(turnTo(20, 95));
    EXPECT_EQ(targeting.target()->state, MoveState::kArrived);
    EXPECT_TRUE(messages.bars().empty()) << "the refusal stays on screen";
}

TEST_F(GuardedMoveTest, TelescopeIsNotTurnedIntoTheSun) {
    // Where it is noon now, half way to the pole: the Sun is up at every time of year.
    const double hours = clock.utcNow().time().msecsSinceStartOfDay() / 3.6e6;
    const targeting::Place place{.latitude = Angle::fromDeg(45), .longitude = Angle::fromDeg((12 - hours) * 15)};
    const targeting::SunPosition sun = targeting::sunPosition(place, clock.utcNow());
    ASSERT_LT(sun.zenith_angle, Angle::fromGon(95));
    set([&](AimingSettings& aiming) {
        aiming.avoids_sun = true;
        aiming.place = place;
    });
    ASSERT_TRUE(turnTo(sun.azimuth.gon(), sun.zenith_angle.gon()));
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("Sun"));
}

TEST_F(GuardedMoveTest, WoundCableOffersTheLongWayWhichUnwindsIt) {
    set([](AimingSettings& aiming) { aiming.most_wound = Angle::fromGon(300); });
    for (const double ha_gon : {120.0, 240.0}) {
        ASSERT_TRUE(turnTo(ha_gon, 95));
        ASSERT_EQ(targeting.target()->state, MoveState::kArrived);
    }
    ASSERT_TRUE(turnTo(340, 95));
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);
    ASSERT_EQ(messages.bars().back().action, MessageAction::kTurnTheLongWay);
    targeting.moveTheLongWay();
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }, 120s));
    EXPECT_EQ(targeting.target()->state, MoveState::kArrived) << targeting.target()->sentence.toStdString();
    EXPECT_THAT(true_pointing->at(clock.now()).ha, IsNearAngle(Angle::fromGon(340), Angle::fromCc(30)));
    ASSERT_TRUE(instrument.wound().has_value());
    EXPECT_LT(std::abs(instrument.wound()->gon()), 120.0);
}

}  // namespace
}  // namespace pmts::app
