#include "app/field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

using test::IsNearAngle;

class TargetingPresenterTest : public FieldTest {
protected:
    void SetUp() override { connectInstrument(); }
};

TEST_F(TargetingPresenterTest, ClickShowsTheTargetAndItsRangeBeforeAnythingMoves) {
    showFrames();
    sent.clear();
    targeting.aimAtLivePixel({900, 300});
    pass(2s);
    ASSERT_TRUE(targeting.target().has_value());
    EXPECT_FALSE(targeting.target()->ha_text.isEmpty());
    EXPECT_THAT(targeting.target()->range_text.toStdString(), testing::HasSubstr("(assumed)"));
    EXPECT_THAT(sent, testing::Not(testing::HasSubstr("WS="))) << "the instrument was told to turn";
}

TEST_F(TargetingPresenterTest, MoveGoesThroughQueuedAndTurningToArrived) {
    QList<MoveState> states;
    QObject::connect(&targeting, &TargetingPresenter::targetChanged, [&] {
        if (targeting.target() && (states.isEmpty() || states.last() != targeting.target()->state)) {
            states.append(targeting.target()->state);
        }
    });
    ASSERT_TRUE(turnTo(30, 95));
    EXPECT_EQ(states, (QList<MoveState>{MoveState::kAimed, MoveState::kQueued, MoveState::kTurning, MoveState::kArrived}));
    EXPECT_THAT(true_pointing->at(clock.now()).ha, IsNearAngle(Angle::fromGon(30), Angle::fromCc(20)));
}

TEST_F(TargetingPresenterTest, StopReachesTheInstrumentAndEndsTheMove) {
    targeting.aimAtText(QStringLiteral("150"), QStringLiteral("95"));
    targeting.move();
    ASSERT_TRUE(until([this] { return targeting.target()->state == MoveState::kTurning; }));
    pass(300ms);
    targeting.stop();
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }, 5s));
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);
    pass(3s);
    EXPECT_LT(true_pointing->at(clock.now()).ha.gon(), 140.0) << "it turned on";
    EXPECT_TRUE(messages.bars().empty());
}

TEST_F(TargetingPresenterTest, ArrowUpRaisesTheTelescopeByTheStepInBothFaces) {
    targeting.setStepText(QStringLiteral("0.1 gon"));
    targeting.nudge(Direction::kUp);
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    EXPECT_THAT(true_pointing->at(clock.now()).va, IsNearAngle(Angle::fromGon(99.9), Angle::fromCc(20)));

    ASSERT_TRUE(turnTo(200, 300));
    targeting.nudge(Direction::kUp);
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    EXPECT_THAT(true_pointing->at(clock.now()).va, IsNearAngle(Angle::fromGon(300.1), Angle::fromCc(20)));
}

TEST_F(TargetingPresenterTest, ArrowLeftAcrossZeroGoesTheShortWay) {
    targeting.nudge(Direction::kLeft);
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    // 5' is 0.092593 gon: the step printed on the thesis's panel.
    EXPECT_THAT(true_pointing->at(clock.now()).ha, IsNearAngle(Angle::fromGon(399.907407), Angle::fromCc(20)));
}

TEST_F(TargetingPresenterTest, TwoQuickArrowsAddUp) {
    targeting.setStepText(QStringLiteral("1 gon"));
    targeting.nudge(Direction::kRight);
    pass(50ms);
    targeting.nudge(Direction::kRight);
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    EXPECT_THAT(true_pointing->at(clock.now()).ha, IsNearAngle(Angle::fromGon(2), Angle::fromCc(20)));
}

TEST_F(TargetingPresenterTest, StepIsFiveMinutesUntilTypedOtherwise) {
    EXPECT_EQ(targeting.stepText(), QStringLiteral("5'"));
    targeting.setStepText(QStringLiteral("2*30\""));
    EXPECT_EQ(targeting.stepText(), QStringLiteral("1'"));
    EXPECT_NEAR(preferences.settings().arrow_step.arcsec(), 60.0, 1e-9);
}

TEST_F(TargetingPresenterTest, StepThatIsNoAngleIsRefused) {
    QSignalSpy refused(&targeting, &TargetingPresenter::stepRejected);
    targeting.setStepText(QStringLiteral("far"));
    targeting.setStepText(QStringLiteral("0"));
    targeting.setStepText(QStringLiteral("-1 gon"));
    EXPECT_EQ(refused.size(), 3);
    EXPECT_EQ(targeting.stepText(), QStringLiteral("5'"));
}

TEST_F(TargetingPresenterTest, MoveWithoutATargetSaysWhatToDo) {
    targeting.move();
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("Click it"));
}

TEST_F(TargetingPresenterTest, MoveWithoutAnInstrumentOffersTheConnectionPage) {
    targeting.aimAtText(QStringLiteral("10"), QStringLiteral("90"));
    instrument.disconnectInstrument();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kDisconnected; }));
    targeting.move();
    EXPECT_FALSE(targeting.isMoving());
    EXPECT_EQ(messages.bars().back().action, MessageAction::kOpenConnectionPage);
}

TEST_F(TargetingPresenterTest, TargetOutsideTheMotionLimitsIsLostAndSaysWhy) {
    ASSERT_TRUE(turnTo(20, 1));  // the telescope would look into its own axis
    EXPECT_EQ(targeting.target()->state, MoveState::kLost);
    EXPECT_FALSE(messages.bars().empty());
    EXPECT_FALSE(targeting.target()->sentence.isEmpty());
}

TEST_F(TargetingPresenterTest, DoubleClickOnARecordedPointTurnsBackToIt) {
    openJob();
    ASSERT_TRUE(turnTo(5, 98));
    ASSERT_TRUE(recordPoint());
    ASSERT_TRUE(turnTo(350, 100));
    targeting.moveToPoint(points.points().at(0).row_id);
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    EXPECT_THAT(true_pointing->at(clock.now()).ha, IsNearAngle(Angle::fromGon(5), Angle::fromCc(30)));
    EXPECT_THAT(true_pointing->at(clock.now()).va, IsNearAngle(Angle::fromGon(98), Angle::fromCc(30)));
}

TEST_F(TargetingPresenterTest, ClickInFaceTwoIsAimedAtInFaceTwo) {
    ASSERT_TRUE(turnTo(200, 300));  // face II, the same line of sight as HA 0, VA 100
    showFrames();
    targeting.moveToLivePixel({700, 330});
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    EXPECT_EQ(targeting.target()->state, MoveState::kArrived);
    EXPECT_NEAR(true_pointing->at(clock.now()).va.gon(), 300.0, 5.0);
    EXPECT_NEAR(true_pointing->at(clock.now()).ha.gon(), 200.0, 5.0);
}

TEST_F(TargetingPresenterTest, TextsFollowTheUnits) {
    targeting.aimAtText(QStringLiteral("100 gon"), QStringLiteral("50 gon"));
    preferences.setUnits({.angle_unit = core::AngleUnit::kDegree, .length_unit = core::LengthUnit::kMetre, .length_decimals = 3});
    EXPECT_EQ(targeting.target()->ha_text, QStringLiteral("90.0000°"));
}

}  // namespace
}  // namespace pmts::app
