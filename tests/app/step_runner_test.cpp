#include "pmts/app/desk/step_runner.hpp"

#include "app/field_fixture.hpp"

namespace pmts::app {
namespace {

class StepRunnerTest : public FieldTest {
protected:
    void SetUp() override {
        connectInstrument();
        targeting.setStepText(QStringLiteral("0.1 gon"));
        QObject::connect(&targeting, &TargetingPresenter::movingChanged, &steps, [this](bool moving) {
            moves += moving ? 1 : 0;
            at_once = at_once || (moving && busy);
            busy = moving;
        });
    }
    void atRest() {
        ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
        pass(1s);
    }
    [[nodiscard]] double trueHa() const { return true_pointing->at(clock.now()).ha.gon(); }

    StepRunner steps{targeting, clock};
    int moves = 0;
    bool busy = false;
    bool at_once = false;  ///< a step was sent before the last had arrived
};

TEST_F(StepRunnerTest, ShortPressIsOneStep) {
    steps.keyPressed(Direction::kRight);
    pass(150ms);
    steps.keyReleased();
    atRest();
    EXPECT_EQ(moves, 1);
    EXPECT_NEAR(trueHa(), 0.1, 0.002);
}

TEST_F(StepRunnerTest, HeldLongerItRunsAndEachStepWaitsForTheLast) {
    steps.keyPressed(Direction::kRight);
    ASSERT_TRUE(until([this] { return moves >= 6; }));
    EXPECT_TRUE(steps.isRunning());
    steps.released();
    const int sent_until_release = moves;
    atRest();
    EXPECT_EQ(moves, sent_until_release) << "it ran on after the release";
    EXPECT_FALSE(at_once);
    EXPECT_NEAR(trueHa(), 0.1 * moves, 0.005);
}

TEST_F(StepRunnerTest, KeyThatTheScreenRepeatsAsReleaseAndPressIsHeld) {
    steps.keyPressed(Direction::kRight);
    for (int i = 0; i < 40; ++i) {
        pass(33ms);
        steps.keyReleased();
        pass(1ms);
        steps.keyPressed(Direction::kRight);
    }
    EXPECT_TRUE(steps.isRunning());
    EXPECT_FALSE(at_once);
    steps.keyReleased();
    pass(StepRunner::kKeyGap);
    EXPECT_FALSE(steps.isRunning());
}

TEST_F(StepRunnerTest, TwoQuickTapsAreTwoSteps) {
    for (int i = 0; i < 2; ++i) {
        steps.keyPressed(Direction::kRight);
        pass(60ms);
        steps.keyReleased();
        pass(60ms);
    }
    atRest();
    EXPECT_NEAR(trueHa(), 0.2, 0.002);
}

TEST_F(StepRunnerTest, EscapeEndsTheRunThoughTheKeyIsStillDown) {
    steps.keyPressed(Direction::kRight);
    ASSERT_TRUE(until([this] { return moves >= 3 && targeting.isMoving(); }));
    targeting.stop();
    atRest();
    const int sent_until_stop = moves;
    pass(3s);
    EXPECT_EQ(moves, sent_until_stop);
    EXPECT_FALSE(steps.isRunning());
}

TEST_F(StepRunnerTest, ButtonHeldDownRunsAndTheClickThatEndsItIsNoStep) {
    steps.buttonPressed(Direction::kRight);
    pass(100ms);
    EXPECT_EQ(moves, 0);
    ASSERT_TRUE(until([this] { return moves >= 3; }));
    const int sent_until_release = moves;
    steps.step(Direction::kRight);  // the click of the release
    atRest();
    EXPECT_EQ(moves, sent_until_release);
}

TEST_F(StepRunnerTest, ClickedButtonIsOneStep) {
    steps.buttonPressed(Direction::kRight);
    pass(100ms);
    steps.step(Direction::kRight);
    atRest();
    EXPECT_EQ(moves, 1);
}

TEST_F(StepRunnerTest, CablePulledEndsTheRun) {
    steps.keyPressed(Direction::kRight);
    ASSERT_TRUE(until([this] { return moves >= 3; }));
    unplug();
    ASSERT_TRUE(until([this] { return !steps.isRunning(); }));
}

}  // namespace
}  // namespace pmts::app
