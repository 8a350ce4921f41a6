#include "line_fixture.hpp"

namespace pmts::scheduler {
namespace {

class StrayReplyTest : public LineTest {
protected:
    StrayReplyTest() {
        line.on_unsolicited = [this](const protocol::Reply& reply) { unsolicited.push_back(reply.raw); };
    }
    std::vector<std::string> unsolicited;
};

TEST_F(StrayReplyTest, ALateReplyIsNotTakenForTheAnswerOfTheNextInstruction) {
    const auto first = start(readLabel(9));
    clock.advance(2s);
    const auto second = start(readLabel(9));  // even the same question
    link.say("9=11.111\r\n>", 100ms);         // the late one
    link.say("9=22.222\r\n>", 200ms);
    clock.advance(300ms);

    ASSERT_TRUE(second.done());
    EXPECT_EQ(second.answer()->find(9)->data, "22.222");
    EXPECT_EQ(line.counts().late, 1U);
    EXPECT_TRUE(unsolicited.empty());
}

TEST_F(StrayReplyTest, NothingIsSentBeforeTheOwedReplyOrAQuietLine) {
    const auto first = start(readLabel(7));
    clock.advance(2s);
    const auto second = start(readLabel(8));
    clock.advance(499ms);
    EXPECT_EQ(link.written.size(), 1U);
    clock.advance(1ms);

    EXPECT_THAT(link.written, ElementsAre("RG,7\r", "RG,8\r"));
}

TEST_F(StrayReplyTest, AfterACancelInMidTransactionTheReplyIsSwallowed) {
    std::stop_source cancel;
    const auto first = start(readLabel(7), cancel.get_token());
    cancel.request_stop();
    const auto second = start(command("TG\r"));
    link.say("7=10.0000\r\n>", 20ms);
    clock.advance(21ms);
    EXPECT_THAT(link.written, ElementsAre("RG,7\r", "TG\r"));
    link.say(">", 20ms);
    clock.advance(21ms);

    EXPECT_THAT(first.answer(), test::FailedWith(ErrorKind::kCancelled));
    EXPECT_TRUE(second.answer().has_value());
}

TEST_F(StrayReplyTest, AVeryLateReplyIsRecognisedByItsLabel) {
    const auto first = start(readLabel(7));
    clock.advance(4s);  // the quiet time is over
    const auto second = start(readLabel(8));
    link.say("7=10.0000\r\n>", 5ms);
    link.say("8=99.0000\r\n>", 20ms);
    clock.advance(30ms);

    ASSERT_TRUE(second.done());
    EXPECT_EQ(second.answer()->find(8)->data, "99.0000");
    EXPECT_EQ(line.counts().late, 1U);
    EXPECT_TRUE(unsolicited.empty());
}

TEST_F(StrayReplyTest, ASecondReplyIsDropped) {
    const auto first = start(readLabel(7));
    link.say("7=10.0000\r\n>7=10.0000\r\n>", 20ms);
    clock.advance(21ms);
    const auto second = start(readLabel(8));
    link.say("8=99.0000\r\n>", 20ms);
    clock.advance(21ms);

    EXPECT_EQ(second.answer()->find(8)->data, "99.0000");
    EXPECT_EQ(line.counts().doubled, 1U);
    EXPECT_TRUE(unsolicited.empty());
}

TEST_F(StrayReplyTest, ASecondReplyThatArrivesDuringTheNextTransactionIsDropped) {
    const auto first = start(readLabel(7));
    const auto second = start(readLabel(8));
    link.say("7=10.0000\r\n>", 20ms);
    link.say("7=10.0000\r\n>", 34ms);
    link.say("8=99.0000\r\n>", 60ms);
    clock.advance(61ms);

    ASSERT_TRUE(second.done());
    EXPECT_EQ(second.answer()->find(8)->data, "99.0000");
    EXPECT_EQ(line.counts().doubled, 1U);
}

TEST_F(StrayReplyTest, ASecondEmptyReplyIsNotTakenForAReadLabel) {
    const auto write = start(command("WG,26=96.1684\r"));
    const auto read = start(readLabel(26));
    link.say(">", 20ms);
    link.say(">", 21ms);
    link.say("26=96.1684\r\n>", 40ms);
    clock.advance(41ms);

    ASSERT_TRUE(read.done());
    EXPECT_EQ(read.answer()->find(26)->data, "96.1684");
}

TEST_F(StrayReplyTest, ABlockFasterThanTheCommandCanLeaveTheWireIsNoAnswer) {
    line.setByteTime(1041667ns);  // 9600 baud: sixteen bytes take 16.7 ms
    const auto first = start(command("WG,26=96.1684\r"));
    const auto second = start(command("WG,27=177.5612\r"));
    link.say(">", 20ms);
    link.say(">", 21ms);  // the first one doubled
    clock.advance(22ms);
    EXPECT_FALSE(second.done());
    link.say(">", 18ms);
    clock.advance(18ms);

    EXPECT_TRUE(second.done());
}

TEST_F(StrayReplyTest, ARegKeyBlockOnAnIdleLineIsHandedOn) {
    link.say("0\r\n7=10.0000\r\n8=99.0000\r\n9=23.418\r\n>");
    clock.advance(1ms);

    EXPECT_THAT(unsolicited, ElementsAre("0\r\n7=10.0000\r\n8=99.0000\r\n9=23.418\r\n"));
}

TEST_F(StrayReplyTest, ASlaveBlockInTheMiddleOfATransactionIsHandedOnAndTheAnswerStillAwaited) {
    const auto write = start(command("WG,26=96.1684\r"));
    link.say("37=1000.000\r\n38=2000.000\r\n39=50.000\r\n>", 5ms);
    link.say(">", 20ms);
    clock.advance(21ms);

    ASSERT_TRUE(write.done());
    EXPECT_TRUE(write.answer()->items.empty());
    EXPECT_EQ(unsolicited.size(), 1U);
}

TEST_F(StrayReplyTest, StrayMarksBeforeAReadReplyArePassedOver) {
    const auto read = start(readLabel(7));
    link.say(">>>7=10.0000\r\n>", 20ms);
    clock.advance(21ms);

    ASSERT_TRUE(read.done());
    EXPECT_EQ(read.answer()->find(7)->data, "10.0000");
    EXPECT_TRUE(unsolicited.empty());
}

TEST_F(StrayReplyTest, GarbageOnAnIdleLineIsForgottenOnceItIsQuiet) {
    link.say("\x15\x7f~~", 10ms);
    clock.advance(600ms);
    const auto read = start(readLabel(7));
    link.say("7=10.0000\r\n>", 20ms);
    clock.advance(21ms);

    ASSERT_TRUE(read.done());
    EXPECT_EQ(read.answer()->raw, "7=10.0000\r\n");
}

TEST_F(StrayReplyTest, WhateverAnswersNobodyIsToldWithItsKind) {
    std::vector<std::pair<StrayKind, std::string>> strays;
    line.on_stray = [&strays](const Stray& stray) { strays.emplace_back(stray.kind, stray.bytes); };
    const auto given_up = start(readLabel(7));
    clock.advance(2s);
    const auto read = start(readLabel(8));
    link.say("7=10.0000\r\n>", 100ms);
    link.say("8=99.0000\r\n>8=99.0000\r\n>", 200ms);
    link.say("9=23.418\r\n>", 300ms);
    link.say("\x15\x7f\x15>", 400ms);
    link.say("half a bl", 500ms);
    clock.advance(2s);

    EXPECT_TRUE(read.done());
    using enum StrayKind;
    EXPECT_THAT(strays, ElementsAre(std::pair(kLate, "7=10.0000\r\n"), std::pair(kDoubled, "8=99.0000\r\n"),
                                    std::pair(kUnsolicited, "9=23.418\r\n"), std::pair(kNoise, "\x15\x7f\x15"),
                                    std::pair(kNoise, "half a bl")));
    EXPECT_EQ(line.counts().noise, 2U);
}

TEST_F(StrayReplyTest, LineEndsBetweenTheBlocksAreNoNoise) {
    const auto read = start(readLabel(7));
    link.say("7=10.0000\r\n>\r\n", 20ms);
    clock.advance(2s);

    EXPECT_TRUE(read.done());
    EXPECT_EQ(line.counts().noise, 0U);
}

TEST_F(StrayReplyTest, SilenceThatIsUsualIsNoTimeOutOfTheLine) {
    std::vector<TransactionRecord> records;
    line.on_finished = [&records](const TransactionRecord& record) { records.push_back(record); };
    auto instruction = readLabel(7);
    instruction.may_stay_silent = true;
    const auto read = start(instruction);
    clock.advance(2s);

    EXPECT_THAT(read.answer(), test::FailedWith(ErrorKind::kTimeOut));
    ASSERT_EQ(records.size(), 1U);
    EXPECT_TRUE(records[0].may_stay_silent);
    EXPECT_EQ(line.counts().timed_out, 0U);
}

TEST_F(StrayReplyTest, ADeviceThatNeverFallsSilentDoesNotHoldTheLine) {
    for (int i = 0; i < 100; ++i) {
        link.say("$GPGGA,", i * 100ms);
    }
    const auto first = start(readLabel(7));
    const auto second = start(readLabel(8));
    clock.advance(10s);

    EXPECT_TRUE(first.done() && second.done());
}

TEST_F(StrayReplyTest, ALostBlockEndDoesNotSpoilTheNextAnswer) {
    const auto first = start(readLabel(7));
    link.say("7=10.0000\r\n", 20ms);
    clock.advance(3s);
    const auto second = start(readLabel(8));
    link.say("8=99.0000\r\n>", 20ms);
    clock.advance(30ms);

    EXPECT_THAT(first.answer(), test::FailedWith(ErrorKind::kTimeOut));
    ASSERT_TRUE(second.done());
    EXPECT_EQ(second.answer()->raw, "8=99.0000\r\n");
}

}  // namespace
}  // namespace pmts::scheduler
