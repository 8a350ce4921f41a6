#include "line_fixture.hpp"

namespace pmts::scheduler {
namespace {

/// A load command that keeps the line: `*` comes, then lines that nobody answers, then the block end.
class HoldTest : public LineTest {
protected:
    static MicroInstruction load(const Hold& hold) {
        return {.bytes = "LM=A\r", .time_limit = 2s, .prompts = "*", .hold = hold};
    }
    static MicroInstruction fileLine(const Hold& hold) {
        return {.bytes = "5=1\r\n", .time_limit = 2s, .expects_reply = false, .hold = hold};
    }
};

TEST_F(HoldTest, NobodyElseSendsBetweenTheInstructionsOfAHold) {
    auto hold = line.hold();
    link.respond = [](const std::string& sent) { return sent == "LM=A\r" ? "*" : ""; };
    const auto loading = start(load(hold));
    const auto reading = start(readLabel(7));
    clock.advance(100ms);
    ASSERT_TRUE(loading.done());
    const auto line_of_file = start(fileLine(hold));
    clock.advance(100ms);

    EXPECT_TRUE(line_of_file.done());
    EXPECT_THAT(link.written, ElementsAre("LM=A\r", "5=1\r\n"));
    hold.reset();
    clock.advance(100ms);
    EXPECT_EQ(link.written.back(), "RG,7\r");
    EXPECT_FALSE(reading.done());
}

TEST_F(HoldTest, WhatIsOnTheLineIsFinishedBeforeAHoldBegins) {
    const auto reading = start(readLabel(7));
    auto hold = line.hold();
    const auto loading = start(load(hold));
    EXPECT_THAT(link.written, ElementsAre("RG,7\r"));
    link.say("7=10.0000\r\n>", 10ms);
    clock.advance(50ms);
    EXPECT_TRUE(reading.done());
    EXPECT_THAT(link.written, ElementsAre("RG,7\r", "LM=A\r"));
}

TEST_F(HoldTest, ABarLetsTheHoldThatRunsGoToItsEnd) {
    auto hold = line.hold();
    link.respond = [](const std::string& sent) { return sent == "LM=A\r" ? "*" : ""; };
    const auto loading = start(load(hold));
    clock.advance(100ms);
    line.bar(core::Error{.kind = ErrorKind::kRefused, .happened = {}, .remedy = {}, .info_code = {}, .detail = {}});
    const auto line_of_file = start(fileLine(hold));
    const auto reading = start(readLabel(7));
    clock.advance(100ms);
    EXPECT_EQ(link.written.back(), "5=1\r\n");
    EXPECT_FALSE(reading.answer().has_value());
}

TEST_F(HoldTest, ALongAnswerMayTakeLongAsLongAsItGrows) {
    std::string heard;
    MicroInstruction output{.bytes = "OM=A\r", .time_limit = 2s};
    output.growing = [&heard](std::string_view so_far) { heard = so_far; };
    const auto fetching = start(output);
    for (int i = 0; i < 10; ++i) {
        link.say("5=1\r\n", core::Duration(i * 1s));
    }
    clock.advance(9500ms);
    EXPECT_FALSE(fetching.done());
    EXPECT_EQ(heard.size(), 50U);
    clock.advance(2s);
    ASSERT_TRUE(fetching.done());
    EXPECT_EQ(fetching.answer().error().kind, ErrorKind::kTimeOut);
}

TEST_F(HoldTest, ACancelledFileIsHeardToItsEndBeforeAnythingElseIsAsked) {
    std::stop_source stop;
    MicroInstruction output{.bytes = "OM=A\r", .time_limit = 2s};
    output.growing = [](std::string_view) {};
    const auto fetching = start(output, stop.get_token());
    for (int i = 0; i < 50; ++i) {
        link.say("7=1.0000\r\n", core::Duration(i * 100ms));
    }
    link.say(">", 5s);
    clock.advance(200ms);
    stop.request_stop();
    const auto reading = start(readLabel(7));
    clock.advance(4500ms);
    EXPECT_TRUE(fetching.done());
    EXPECT_EQ(link.written.size(), 1U) << "a 7= of the file would be taken for the answer";
    clock.advance(1s);
    EXPECT_EQ(link.written.back(), "RG,7\r");
}

}  // namespace
}  // namespace pmts::scheduler
