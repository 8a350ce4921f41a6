#include "line_fixture.hpp"

namespace pmts::scheduler {
namespace {

TEST_F(LineTest, WritesAtOnceWhenTheLineIsIdle) {
    const auto reading = start(readLabel(7));

    EXPECT_THAT(link.written, ElementsAre("RG,7\r"));  // no event loop turn, no clock in between
}

TEST_F(LineTest, AnswersWithTheBlockWhateverItsStatus) {
    const auto triggered = start(command("TG\r"));
    link.say("23.1\r\n>");
    clock.advance(1ms);

    ASSERT_TRUE(triggered.done());
    ASSERT_TRUE(triggered.answer().has_value());
    EXPECT_EQ(triggered.answer()->status, (protocol::Status{23, 1}));
}

TEST_F(LineTest, TakesAnyChunkingOfABlock) {
    const auto reading = start(readLabel(7));
    for (const char* byte : {"7", "=", "10.2345", "\r", "\n", ">"}) {
        link.say(byte);
    }
    clock.advance(1ms);

    ASSERT_TRUE(reading.done());
    EXPECT_EQ(reading.answer()->find(7)->data, "10.2345");
}

TEST_F(LineTest, SendsTheNextOnlyAfterTheBlockEnd) {
    const auto first = start(readLabel(7));
    const auto second = start(readLabel(8));
    clock.advance(100ms);
    EXPECT_EQ(link.written.size(), 1U);

    link.say("7=10.2345\r\n>");
    clock.advance(0ms);

    EXPECT_THAT(link.written, ElementsAre("RG,7\r", "RG,8\r"));
}

TEST_F(LineTest, CommandsGoBeforePollsAndStopBeforeBoth) {
    const auto running = start(readLabel(7));
    auto poll = readLabel(8);
    poll.priority = Priority::kPoll;
    auto stop = command("PG,3=0\r");
    stop.priority = Priority::kStop;
    const auto polled = start(poll);
    const auto commanded = start(command("TG\r"));
    const auto stopped = start(stop);

    link.respond = [](const std::string& sent) { return sent == "RG,8\r" ? "8=100.0000\r\n>" : ">"; };
    link.say("7=10.2345\r\n>");
    clock.advance(1s);

    EXPECT_THAT(link.written, ElementsAre("RG,7\r", "PG,3=0\r", "TG\r", "RG,8\r"));
    EXPECT_TRUE(polled.done() && commanded.done() && stopped.done());
}

TEST_F(LineTest, StopIsWrittenIntoARunningTransaction) {
    const auto turning = start(command("WS=PH02V02\r", 30s));
    const auto stopped = start(stopCommand());

    EXPECT_THAT(link.written, ElementsAre("WS=PH02V02\r", "PG,3=0\r"));
}

TEST_F(LineTest, AnswersOfAnInterruptedAndTheInterruptingCommandAreToldApartByOrder) {
    std::stop_source cancel;
    const auto turning = start(command("WS=PH02V02\r", 30s), cancel.get_token());
    const auto stopped = start(stopCommand());
    cancel.request_stop();
    link.say("190\r\n>", 10ms);
    link.say(">", 12ms);
    clock.advance(20ms);

    EXPECT_THAT(turning.answer(), test::FailedWith(ErrorKind::kCancelled));
    ASSERT_TRUE(stopped.done());
    EXPECT_FALSE(stopped.answer()->status.has_value());
}

TEST_F(LineTest, AStopThatGetsTheOnlyBlockIsAnsweredByItOnceTheLineIsQuiet) {
    std::stop_source cancel;
    const auto turning = start(command("WS=PH02V02\r", 30s), cancel.get_token());
    const auto stopped = start(stopCommand());
    cancel.request_stop();
    link.say(">", 10ms);  // the interrupted command is never answered
    clock.advance(600ms);

    ASSERT_TRUE(stopped.done());
    EXPECT_TRUE(stopped.answer().has_value());
    EXPECT_TRUE(line.isIdle());
}

TEST_F(LineTest, ATransactionWithoutReplyIsDoneWhenWritten) {
    MicroInstruction off{.bytes = "PV,21\r", .expects_reply = false};
    const auto switched_off = start(off);
    const auto next = start(readLabel(7));
    core::deliverQueuedEvents();

    EXPECT_TRUE(switched_off.done());
    EXPECT_THAT(link.written, ElementsAre("PV,21\r", "RG,7\r"));
}

TEST_F(LineTest, AReplyThatNeverComesEndsAtTheTimeLimit) {
    const auto reading = start(readLabel(7));
    clock.advance(1999ms);
    EXPECT_FALSE(reading.done());
    clock.advance(1ms);

    ASSERT_TRUE(reading.done());
    EXPECT_THAT(reading.answer(), test::FailedWith(ErrorKind::kTimeOut));
}

TEST_F(LineTest, ATimeOutKeepsTheHalfBlockAsEvidence) {
    TransactionRecord record;
    line.on_finished = [&](const TransactionRecord& finished) { record = finished; };
    const auto reading = start(readLabel(7));
    link.say("7=10.2");
    clock.advance(3s);

    EXPECT_TRUE(record.timed_out);
    EXPECT_EQ(record.outcome, Outcome::kTimedOut);
    EXPECT_EQ(record.received, "7=10.2");
}

TEST_F(LineTest, CancellingAQueuedInstructionNeverWritesIt) {
    std::stop_source cancel;
    const auto running = start(readLabel(7));
    const auto waiting = start(readLabel(8), cancel.get_token());
    cancel.request_stop();
    link.say("7=10.2345\r\n>");
    clock.advance(1s);

    EXPECT_THAT(waiting.answer(), test::FailedWith(ErrorKind::kCancelled));
    EXPECT_THAT(link.written, ElementsAre("RG,7\r"));
}

TEST_F(LineTest, ATokenThatIsAlreadyStoppedSendsNothing) {
    std::stop_source cancel;
    cancel.request_stop();
    const auto reading = start(readLabel(7), cancel.get_token());

    EXPECT_THAT(reading.answer(), test::FailedWith(ErrorKind::kCancelled));
    EXPECT_TRUE(link.written.empty());
}

TEST_F(LineTest, UnpluggingCompletesEveryWaiterBeforeItIsReported) {
    const auto running = start(readLabel(7));
    const auto waiting = start(readLabel(8));
    int reports = 0;
    line.on_lost = [&](const core::Error&) {
        ++reports;
        core::deliverQueuedEvents();
        EXPECT_TRUE(running.done() && waiting.done());
    };
    link.unplug();

    EXPECT_EQ(reports, 1);
    EXPECT_THAT(waiting.answer(), test::FailedWith(ErrorKind::kLinkLost));
    EXPECT_TRUE(line.isIdle());
}

TEST_F(LineTest, WithoutALinkACommandIsRefusedAtOnce) {
    link.close();
    const auto reading = start(readLabel(7));
    core::deliverQueuedEvents();

    EXPECT_THAT(reading.answer(), test::FailedWith(ErrorKind::kNotConnected));
}

TEST_F(LineTest, DestroyingTheSchedulerCancelsWhatWaits) {
    auto other = std::make_unique<test::ScriptedLink>(clock);
    auto short_lived = std::make_unique<Scheduler>(*other, clock, gate);
    Watched watched;
    auto running = watch(short_lived->execute(readLabel(7)), watched.outcome);
    short_lived.reset();
    other.reset();
    clock.advance(5s);

    EXPECT_THAT(watched.answer(), test::FailedWith(ErrorKind::kCancelled));
}

TEST_F(LineTest, FailAllEndsEveryWaiterWithTheGivenReason) {
    const auto running = start(readLabel(7));
    const auto waiting = start(readLabel(8));
    line.failAll({.kind = ErrorKind::kRefused,
                  .happened = QStringLiteral("The panel has control."),
                  .remedy = {},
                  .info_code = std::nullopt,
                  .detail = {}});
    core::deliverQueuedEvents();

    EXPECT_THAT(running.answer(), test::FailedWith(ErrorKind::kRefused));
    EXPECT_THAT(waiting.answer(), test::FailedWith(ErrorKind::kRefused));
}

TEST_F(LineTest, RecordsWhenATransactionWaitedWasSentAndEnded) {
    std::vector<TransactionRecord> records;
    line.on_finished = [&](const TransactionRecord& finished) { records.push_back(finished); };
    const auto first = start(readLabel(7));
    const auto second = start(readLabel(8));
    link.say("7=10.2345\r\n>", 20ms);
    link.say("8=99.0000\r\n>", 50ms);
    clock.advance(1s);

    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[1].sent, "RG,8\r");
    EXPECT_EQ(records[1].received, "8=99.0000\r\n");
    EXPECT_EQ(records[1].queued_at, 0ms);
    EXPECT_EQ(records[1].sent_at, 20ms);
    EXPECT_EQ(records[1].finished_at, 50ms);
}

TEST_F(LineTest, ALoadCommandEndsAtItsBareStar) {
    MicroInstruction load{.bytes = "LM=DEMO1\r", .prompts = "*"};
    const auto loading = start(load);
    link.say("*");
    clock.advance(1ms);

    ASSERT_TRUE(loading.done());
    EXPECT_EQ(loading.answer()->raw, "*");
}

TEST_F(LineTest, TheCompensatorDialogueEndsAtItsQuestion) {
    MicroInstruction calibrate{.bytes = "PV,20\r", .prompts = "@!"};
    const auto calibrating = start(calibrate);
    link.say("\r\n!");
    clock.advance(1ms);

    ASSERT_TRUE(calibrating.done());
    EXPECT_EQ(calibrating.answer()->raw, "!");
}

TEST_F(LineTest, WithoutEndMarkABlockEndsWhenTheLineIsQuiet) {
    line.setEndMark(std::nullopt);
    const auto reading = start(readLabel(7));
    link.say("7=10.2345\r\n", 20ms);
    clock.advance(519ms);
    EXPECT_FALSE(reading.done());
    clock.advance(1ms);

    ASSERT_TRUE(reading.done());
    EXPECT_EQ(reading.answer()->find(7)->data, "10.2345");
    EXPECT_FALSE(reading.answer()->ended);
}

TEST_F(LineTest, WithoutEndMarkAPauseWithinALineDoesNotEndTheBlock) {
    line.setEndMark(std::nullopt);
    const auto reading = start(readLabel(7));
    link.say("7=10.2", 20ms);
    link.say("345\r\n", 900ms);
    clock.advance(1500ms);

    ASSERT_TRUE(reading.done());
    EXPECT_EQ(reading.answer()->find(7)->data, "10.2345");
}

TEST_F(LineTest, WithoutEndMarkSilenceAnswersAWrite) {
    line.setEndMark(std::nullopt);
    auto write = command("WG,26=96.1684\r");
    write.silence_is_success = true;
    const auto written = start(write);
    clock.advance(500ms);

    ASSERT_TRUE(written.done());
    EXPECT_TRUE(written.answer()->items.empty());
}

}  // namespace
}  // namespace pmts::scheduler
