#include "pmts/transport/replay_link.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "pmts/transport/memory_link.hpp"
#include "pmts/transport/recorder.hpp"
#include "support/matchers.hpp"
#include "transport/link_probe.hpp"

#include <QTemporaryDir>

namespace pmts::transport {
namespace {

using namespace std::chrono_literals;
using core::ErrorKind;
using test::FailedWith;
using test::LinkProbe;
using testing::ElementsAre;
using enum Direction;

class ReplayLinkTest : public testing::Test {
protected:
    core::VirtualClock clock;
};

Session sessionWith(std::vector<SessionEvent> events) {
    return {.began_utc = {}, .link = {}, .events = std::move(events)};
}

const std::vector<SessionEvent> kShot{
    {100ms, kSent, "TG\r"},
    {150ms, kReceived, ">"},
    {200ms, kSent, "RG\r"},
    {260ms, kReceived, "0\r\n7=10.2345\r\n>"},
    {900ms, kSent, "RG\r"},
    {960ms, kReceived, "0\r\n7=10.2345\r\n"},
    {980ms, kReceived, "9=145.324\r\n>"},
};

TEST_F(ReplayLinkTest, AnswersComeWithTheRecordedDelays) {
    ReplayLink link(sessionWith(kShot), clock);
    LinkProbe probe(link);
    ASSERT_TRUE(link.open().has_value());
    link.write("TG\r");
    clock.advance(49ms);
    EXPECT_EQ(probe.received, "");
    clock.advance(1ms);
    EXPECT_EQ(probe.received, ">");
}

TEST_F(ReplayLinkTest, SpeedShortensTheDelays) {
    ReplayLink link(sessionWith(kShot), clock, {.speed = 10.0, .name = QStringLiteral("x")});
    LinkProbe probe(link);
    ASSERT_TRUE(link.open().has_value());
    link.write("TG\r");
    clock.advance(5ms);
    EXPECT_EQ(probe.received, ">");
    EXPECT_THROW(ReplayLink({}, clock, {.speed = 0.0, .name = {}}), std::logic_error);
}

TEST_F(ReplayLinkTest, EqualQuestionsGetTheirAnswersInTheRecordedOrder) {
    ReplayLink link(sessionWith(kShot), clock);
    LinkProbe probe(link);
    ASSERT_TRUE(link.open().has_value());
    for (const char* command : {"TG\r", "RG\r", "RG\r"}) {
        link.write(command);
        clock.advance(1s);
    }
    EXPECT_EQ(probe.received, ">0\r\n7=10.2345\r\n>0\r\n7=10.2345\r\n9=145.324\r\n>");
    EXPECT_TRUE(link.isAtEnd());
    EXPECT_TRUE(link.unexpectedWrites().empty());
}

TEST_F(ReplayLinkTest, OnePollMoreThanRecordedGetsTheLatestAnswerAgain) {
    ReplayLink link(sessionWith(kShot), clock);
    ASSERT_TRUE(link.open().has_value());
    for (const char* command : {"TG\r", "RG\r", "RG\r"}) {
        link.write(command);
    }
    clock.advance(1s);
    LinkProbe probe(link);
    link.write("RG\r");
    clock.advance(1s);
    EXPECT_EQ(probe.received, "0\r\n7=10.2345\r\n9=145.324\r\n>");
}

TEST_F(ReplayLinkTest, LeftOutQuestionIsSkipped) {
    ReplayLink link(sessionWith(kShot), clock);
    LinkProbe probe(link);
    ASSERT_TRUE(link.open().has_value());
    link.write("RG\r");
    clock.advance(1s);
    EXPECT_EQ(probe.received, "0\r\n7=10.2345\r\n>");
}

TEST_F(ReplayLinkTest, UnknownQuestionGetsNoAnswerAndIsKept) {
    ReplayLink link(sessionWith(kShot), clock);
    LinkProbe probe(link);
    ASSERT_TRUE(link.open().has_value());
    link.write("WS=PH02\r");
    clock.advance(10s);
    EXPECT_EQ(probe.received, "");
    EXPECT_THAT(link.unexpectedWrites(), ElementsAre("WS=PH02\r"));
}

TEST_F(ReplayLinkTest, UnsolicitedBlocksAndTheLossComeByThemselves) {
    ReplayLink link(sessionWith({{500ms, kReceived, "7=1\r\n>"}, {2s, kLost, "The cable."}}), clock);
    LinkProbe probe(link);
    ASSERT_TRUE(link.open().has_value());
    clock.advance(500ms);
    EXPECT_EQ(probe.received, "7=1\r\n>");
    clock.advance(10s);
    ASSERT_EQ(probe.losses.size(), 1U);
    EXPECT_EQ(probe.losses[0].happened, QStringLiteral("The cable."));
    EXPECT_FALSE(link.isOpen());
}

TEST_F(ReplayLinkTest, LinkMayBeDestroyedInsideItsCallback) {
    auto link = std::make_unique<ReplayLink>(sessionWith(kShot), clock);
    ASSERT_TRUE(link->open().has_value());
    link->on_received = [&](std::string_view) { link.reset(); };
    link->write("TG\r");
    clock.advance(1s);
    EXPECT_EQ(link, nullptr);
}

TEST_F(ReplayLinkTest, WhatTheRecorderWroteIsPlayedAsItWas) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("shot.log"));
    auto pair = makeMemoryPair(clock, {.baud = 9600.0, .first_to_second = {}, .second_to_first = {}});
    pair.second->on_received = [&](std::string_view bytes) {
        if (bytes.ends_with('\r')) {
            pair.second->write("0\r\n7=10.2345\r\n>");
        }
    };
    ASSERT_TRUE(pair.second->open().has_value());
    Recorder recorder(std::move(pair.first), clock, path);
    ASSERT_TRUE(recorder.open().has_value());
    recorder.write("RG\r");
    clock.advance(1s);

    const auto replay = ReplayLink::fromFile(path, clock);
    ASSERT_TRUE(replay.has_value());
    EXPECT_EQ((*replay)->description(), QStringLiteral("replay of shot.log"));
    LinkProbe probe(**replay);
    ASSERT_TRUE((*replay)->open().has_value());
    (*replay)->write("RG\r");
    clock.advance(18ms);  // 3 bytes to the instrument and 15 back take 18.75 ms
    EXPECT_NE(probe.received, "0\r\n7=10.2345\r\n>");
    clock.advance(1ms);
    EXPECT_EQ(probe.received, "0\r\n7=10.2345\r\n>");
    EXPECT_THAT(ReplayLink::fromFile(folder.filePath(QStringLiteral("none")), clock),
                FailedWith(ErrorKind::kFile));
}

}  // namespace
}  // namespace pmts::transport
