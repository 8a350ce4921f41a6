#include "line_fixture.hpp"

namespace pmts::scheduler {
namespace {

MicroInstruction critical() { return {.bytes = "PV,20\r", .time_limit = 2s, .time_critical = true}; }

TEST_F(LineTest, TheVideoGateIsClosedFromTheSendingToTheReply) {
    EXPECT_TRUE(gate.isOpen());
    const auto calibrating = start(critical());
    EXPECT_FALSE(gate.isOpen());
    link.say(">", 30ms);
    clock.advance(30ms);

    EXPECT_TRUE(gate.isOpen());
    EXPECT_EQ(gate.statistics().pauses, 1U);
    EXPECT_EQ(gate.statistics().longest, 30ms);
}

TEST_F(LineTest, TheVideoGateOpensAtTheTimeOut) {
    const auto calibrating = start(critical());
    clock.advance(2s);

    EXPECT_TRUE(gate.isOpen());
    EXPECT_EQ(gate.statistics().total, 2s);
}

TEST_F(LineTest, TheVideoGateOpensWhenTheCableIsPulled) {
    const auto calibrating = start(critical());
    link.unplug();

    EXPECT_TRUE(gate.isOpen());
}

TEST_F(LineTest, AQueuedCriticalInstructionKeepsTheVideoRunning) {
    const auto running = start(readLabel(7));
    const auto waiting = start(critical());

    EXPECT_TRUE(gate.isOpen());
}

TEST_F(LineTest, OrdinaryTransactionsNeverPauseTheVideo) {
    const auto running = start(readLabel(7));

    EXPECT_TRUE(gate.isOpen());
    EXPECT_EQ(gate.statistics().pauses, 0U);
}

}  // namespace
}  // namespace pmts::scheduler
