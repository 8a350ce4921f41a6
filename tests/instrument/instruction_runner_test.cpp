#include "pmts/instrument/instruction_runner.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "pmts/protocol/info_code.hpp"
#include "support/matchers.hpp"
#include "support/run_to_end.hpp"
#include "support/scripted_link.hpp"

#include <gtest/gtest.h>

#include <deque>

namespace pmts::instrument {
namespace {

using namespace std::chrono_literals;
using core::ErrorKind;
using testing::ElementsAre;

constexpr const char* kEnd = "\r\x04";

class InstructionRunnerTest : public testing::Test {
protected:
    InstructionRunnerTest() {
        line.setEndMark('\x04');
        line.setStreamHead("A,");
        link.respond = [this](const std::string&) -> std::optional<std::string> {
            if (replies.empty()) {
                return std::nullopt;
            }
            auto reply = replies.front();
            replies.pop_front();
            return reply ? std::optional(*reply + kEnd) : std::nullopt;
        };
        runner.on_step = [this](const StepOutcome& step) { told.push_back(step); };
    }
    static protocol::TableRoutine routine(const std::string& steps) {
        auto table = protocol::readInstructionTable("routine some\n" + steps);
        EXPECT_TRUE(table.problems.empty());
        return table.routines.at(0);
    }
    core::Result<RoutineOutcome> run(const std::string& steps, std::map<std::string, double> numbers = {}) {
        auto outcome = test::runToEnd(runner.run(routine(steps), std::move(numbers), stop.get_token()), clock, 60s);
        EXPECT_TRUE(outcome.has_value());
        return outcome ? *outcome : core::cancelled();
    }
    [[nodiscard]] std::vector<StepVerdict> verdicts() const {
        std::vector<StepVerdict> all;
        for (const auto& step : told) {
            all.push_back(step.verdict);
        }
        return all;
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    test::ScriptedLink link{clock};
    scheduler::Scheduler line{link, clock, gate};
    InstructionRunner runner{line, clock};
    std::deque<std::optional<std::string>> replies;
    std::vector<StepOutcome> told;
    std::stop_source stop;
};

const std::string kBracket = "send WV,102=0\nexpect 0.8\nsend PV,3={mode 0..4}\nexpect 240.8\nfail 242.8\nsend WV,102=1\nexpect 0.8\nalways\n";

TEST_F(InstructionRunnerTest, EveryStepIsSentAfterTheReplyToTheOneBefore) {
    replies = {"0.8", "240.8", "0.8"};
    const auto outcome = run(kBracket, {{"mode", 3}});

    ASSERT_TRUE(outcome.has_value());
    EXPECT_THAT(link.written, ElementsAre("WV,102=0\r", "PV,3=3\r", "WV,102=1\r"));
    EXPECT_EQ(outcome->routine, "some");
    ASSERT_EQ(outcome->steps.size(), 3U);
    EXPECT_EQ(outcome->steps[1].line, 4);
    EXPECT_EQ(outcome->steps[1].received, "240.8\r");
    EXPECT_GE(outcome->steps[1].sent_at, outcome->steps[0].finished_at);
}

TEST_F(InstructionRunnerTest, NothingIsSentBeforeEveryNumberIsInItsRange) {
    EXPECT_THAT(run(kBracket, {{"mode", 5}}), test::FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(run(kBracket), test::FailedWith(ErrorKind::kBadInput));
    EXPECT_TRUE(link.written.empty());
}

TEST_F(InstructionRunnerTest, AFailureEndsItAndWhatWasTakenIsGivenBack) {
    replies = {"0.8", "242.8", "0.8"};
    const auto outcome = run(kBracket, {{"mode", 1}});

    ASSERT_THAT(outcome, test::FailedWith(ErrorKind::kDevice));
    EXPECT_EQ(outcome.error().info_code, 242);
    const auto of_code = protocol::errorFromStatus({.code = 242, .suffix = 8}).remedy;
    EXPECT_EQ(outcome.error().remedy, of_code) << "what to do, not where to read";
    EXPECT_THAT(verdicts(), ElementsAre(StepVerdict::kExpected, StepVerdict::kFailed, StepVerdict::kExpected));
    EXPECT_EQ(link.written.back(), "WV,102=1\r");
}

TEST_F(InstructionRunnerTest, AReplyThatTheTableDoesNotKnowEndsIt) {
    replies = {"#4", "0.8"};
    EXPECT_THAT(run(kBracket, {{"mode", 1}}), test::FailedWith(ErrorKind::kProtocol));
    EXPECT_THAT(verdicts(), ElementsAre(StepVerdict::kUnknown, StepVerdict::kExpected));
}

TEST_F(InstructionRunnerTest, AMissingReplyEndsItUnlessItMayBeMissing) {
    replies = {std::nullopt, "0.8"};
    EXPECT_THAT(run("send PV,8=9\nexpect 240.8\nwithin 2\nsend WV,102=1\nexpect 0.8\n"), test::FailedWith(ErrorKind::kTimeOut));
    EXPECT_THAT(verdicts(), ElementsAre(StepVerdict::kTimedOut));

    replies = {std::nullopt, "0.8"};
    ASSERT_TRUE(run("send PV,4=0\nexpect 240.8\nwithin 1\noptional\nsend WV,102=1\nexpect 0.8\n").has_value());
    EXPECT_EQ(told[1].verdict, StepVerdict::kMissing);
}

TEST_F(InstructionRunnerTest, AnOptionalReplyThatComesLateAnswersNoLaterStep) {
    replies = {std::nullopt, std::nullopt};
    const auto late = [this](const std::string& command) -> std::optional<std::string> {
        if (command.starts_with("PV,4")) {
            link.say(std::string("240.8") + kEnd, 1700ms);  // the step gives up after 1 s, the line is quiet at 1.5 s
        } else {
            link.say(std::string("0.8") + kEnd, 400ms);
        }
        return std::nullopt;
    };
    link.respond = late;
    EXPECT_TRUE(run("send PV,4=0\nexpect 240.8\nwithin 1\noptional\nsend WV,102=1\nexpect 0.8\n").has_value());
    EXPECT_EQ(told[1].received, "0.8\r");
}

TEST_F(InstructionRunnerTest, TheStreamAnswersNobodyAndDoesNotHoldTheLine) {
    for (int i = 0; i < 100; ++i) {
        link.say("A,166=96.16838\rA,165=177.56115\x04", 50ms + i * 298ms);
    }
    replies = {std::nullopt, "0.8"};
    ASSERT_TRUE(run("send PV,4=0\nexpect 240.8\nwithin 1\noptional\nsend WV,102=1\nexpect 0.8\n").has_value());
    EXPECT_EQ(told[1].received, "0.8\r");
    EXPECT_LE(told[1].sent_at, 1600ms);  // 1 s for the reply, 0.5 s quiet beside the stream
    EXPECT_EQ(line.counts().unsolicited, 0U);
}

TEST_F(InstructionRunnerTest, ADamagedBlockOfTheStreamIsNoReply) {
    link.say("#,166=96.16838\rA,165=177.56115\x04", 5ms);
    replies = {"240.8"};
    EXPECT_TRUE(run("send PV,8=9\nexpect 240.8\n").has_value());
}

TEST_F(InstructionRunnerTest, ATimeCriticalStepClosesTheVideoGateUntilItsReply) {
    bool open_while_waiting = true, open_between = false;
    link.respond = [&](const std::string& command) -> std::optional<std::string> {
        (command.starts_with("PV") ? open_while_waiting : open_between) = gate.isOpen();
        return (command.starts_with("PV") ? "240.8" : "0.8") + std::string(kEnd);
    };
    ASSERT_TRUE(run("send PV,30=1\nexpect 240.8\ntime_critical\nsend WV,102=1\nexpect 0.8\n").has_value());
    EXPECT_FALSE(open_while_waiting);
    EXPECT_TRUE(open_between);
    EXPECT_TRUE(told[0].video_paused);
    EXPECT_FALSE(told[1].video_paused);
}

TEST_F(InstructionRunnerTest, ACancelLetsTheStepOnTheWireEndAndGivesBack) {
    replies = {"0.8", "240.8", "0.8"};
    runner.on_begin = [this](std::size_t index) {
        if (index == 1) {
            stop.request_stop();
        }
    };
    EXPECT_THAT(run("send WV,102=0\nexpect 0.8\nsend PV,8=9\nexpect 240.8\nsend PV,4=0\noptional\nsend WV,102=1\nexpect 0.8\nalways\n"),
                test::FailedWith(ErrorKind::kCancelled));
    EXPECT_THAT(link.written, ElementsAre("WV,102=0\r", "PV,8=9\r", "WV,102=1\r"));
    EXPECT_THAT(verdicts(), testing::Each(StepVerdict::kExpected));
}

TEST_F(InstructionRunnerTest, ACancelDoesNotWaitForABaseThatIsSilent) {
    runner.on_begin = [this](std::size_t) { stop.request_stop(); };
    EXPECT_THAT(run("send PV,8=9\nexpect 240.8\nwithin 3000\n"), test::FailedWith(ErrorKind::kCancelled));
    EXPECT_LE(clock.now(), 3s);
    EXPECT_THAT(verdicts(), ElementsAre(StepVerdict::kBrokenOff));
}

TEST_F(InstructionRunnerTest, APauseIsKeptBeforeTheNextStep) {
    replies = {"240.8", "0.8"};
    ASSERT_TRUE(run("send PV,8=9\nexpect 240.8\npause 2.5\nsend WV,102=1\nexpect 0.8\n").has_value());
    EXPECT_GE(told[1].sent_at - told[0].finished_at, 2500ms);
}

TEST_F(InstructionRunnerTest, APulledCableEndsIt) {
    runner.on_begin = [this](std::size_t index) {
        if (index == 0) {
            core::post([this] { link.unplug(); });
        }
    };
    EXPECT_THAT(run("send PV,8=9\nexpect 240.8\n"), test::FailedWith(ErrorKind::kLinkLost));
}

}  // namespace
}  // namespace pmts::instrument
