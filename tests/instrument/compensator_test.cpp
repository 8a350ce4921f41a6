#include "scripted_instrument.hpp"

namespace pmts::instrument {
namespace {

using testing::Contains;
using testing::Not;

/// An instrument that asks before it turns.
class CompensatorTest : public DriverTest {
protected:
    CompensatorTest() {
        link.respond = [this](const std::string& command) -> std::optional<std::string> {
            if (command.empty()) {  // PMTS only listens
                return std::nullopt;
            }
            if (command == "PV,20\r") {
                return "!";
            }
            if (command == "N\r") {
                return ">";
            }
            if (command == "Y\r") {
                link.say("@", 1s);
                link.say(">", 15s);
                return std::nullopt;
            }
            return station.answer(command);
        };
    }
    core::Completion<bool> ask() {
        ++questions;
        question.emplace();
        if (answer) {
            question->complete(*answer);
        }
        return *question;
    }
    auto calibrate() { return driver.calibrateCompensator([this] { return ask(); }, stop.get_token()); }

    int questions = 0;
    std::optional<bool> answer;
    std::optional<core::Completion<bool>> question;
    std::stop_source stop;
};

TEST_F(CompensatorTest, YesLetsItTurnAndItsBlockEndsTheRun) {
    connect();
    answer = true;
    const auto outcome = run(calibrate());
    ASSERT_TRUE(outcome.has_value());
    EXPECT_EQ(questions, 1);
    EXPECT_TRUE(outcome->ended_by_block && outcome->showed_compensator);
    EXPECT_FALSE(outcome->answered_no);
    EXPECT_EQ(sent("Y"), 1);
}

TEST_F(CompensatorTest, NoIsSaidAndRememberedSoThatNobodyCallsItCalibrated) {
    connect();
    answer = false;
    const auto outcome = run(calibrate());
    ASSERT_TRUE(outcome.has_value());
    EXPECT_TRUE(outcome->answered_no);
    EXPECT_EQ(sent("N"), 1);
}

TEST_F(CompensatorTest, CancelWhileItAsksAnswersNoBecauseTheInstrumentStillWaits) {
    connect();
    const auto timer = clock.callAfter(5s, [this] {
        driver.stop();
        question.reset();
    });
    EXPECT_THAT(run(calibrate()), test::FailedWith(ErrorKind::kCancelled));
    EXPECT_THAT(link.written, Contains("N\r"));
    EXPECT_THAT(link.written, Not(Contains("PG,3=0\r"))) << "it would be taken for the answer";
    EXPECT_FALSE(driver.isBusy());
}

TEST_F(CompensatorTest, TheCallersTokenCancelsTheQuestionJustTheSame) {
    connect();
    const auto timer = clock.callAfter(5s, [this] {
        stop.request_stop();
        question->complete(true);
    });
    EXPECT_THAT(run(calibrate()), test::FailedWith(ErrorKind::kCancelled));
    EXPECT_EQ(sent("Y"), 0) << "nobody wants it to turn any more";
    EXPECT_EQ(sent("N"), 1);
}

TEST_F(CompensatorTest, AQuestionThatIsDroppedWithTheLineEndsTheRunAtOnce) {
    connect();
    const auto timer = clock.callAfter(5s, [this] {
        link.unplug();
        question.reset();
    });
    const core::Duration before = clock.now();
    EXPECT_FALSE(run(calibrate()).has_value());
    EXPECT_LT(clock.now() - before, 6s);
    EXPECT_FALSE(driver.isBusy());
}

}  // namespace
}  // namespace pmts::instrument
