#include "pmts/transport/recorder.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "pmts/transport/memory_link.hpp"
#include "support/matchers.hpp"
#include "transport/link_probe.hpp"

#include <QTemporaryDir>

namespace pmts::transport {
namespace {

using namespace std::chrono_literals;
using test::LinkProbe;
using testing::ElementsAre;

class RecorderTest : public testing::Test {
protected:
    RecorderTest() : recorder(std::move(pair.first), clock, path), probe(recorder) {
        EXPECT_TRUE(pair.second->open().has_value());
        pair.second->on_received = [this](std::string_view) { pair.second->write("0\r\n>"); };
    }

    core::VirtualClock clock;
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("session.log"));
    MemoryPair pair = makeMemoryPair(clock);
    Recorder recorder;
    LinkProbe probe;
};

TEST_F(RecorderTest, BothDirectionsAreInTheLogWithTheirTimes) {
    ASSERT_TRUE(recorder.open().has_value());
    clock.advance(40ms);
    recorder.write("RG\r");
    clock.advance(1s);
    EXPECT_EQ(probe.received, "0\r\n>");
    const auto sessions = readSessionLog(path);
    ASSERT_TRUE(sessions.has_value());
    EXPECT_EQ(sessions->front().link, QStringLiteral("memory"));
    EXPECT_THAT(sessions->front().events, ElementsAre(SessionEvent{40ms, Direction::kSent, "RG\r"},
                                                      SessionEvent{40ms, Direction::kReceived, "0\r\n>"}));
}

TEST_F(RecorderTest, LossIsPassedOnOnceAndRecorded) {
    ASSERT_TRUE(recorder.open().has_value());
    pair.second->unplug();
    clock.advance(1s);
    EXPECT_EQ(probe.losses.size(), 1U);
    const auto events = readSessionLog(path)->front().events;
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].direction, Direction::kLost);
}

TEST_F(RecorderTest, EachOpenAppendsASession) {
    for (const char* command : {"RG\r", "TG\r"}) {
        ASSERT_TRUE(recorder.open().has_value());
        recorder.write(command);
        recorder.close();
    }
    const auto sessions = readSessionLog(path);
    ASSERT_EQ(sessions->size(), 2U);
    EXPECT_EQ(sessions->front().events[0].bytes, "RG\r");
    EXPECT_EQ(sessions->back().events[0].bytes, "TG\r");
}

TEST_F(RecorderTest, LineThatAKilledProgramLeftIsNeverReadAsWhole) {
    for (const char* torn : {"1.0 > WG,26=9", "1.0 > RG\\", "1.0 > RG\\x", "1.0 > RG\\x0", "1.0 >"}) {
        QFile log(path);
        ASSERT_TRUE(log.open(QIODevice::WriteOnly));
        log.write("@ 2026-06-01T06:00:00.000Z memory\n");
        log.write(torn);
        log.close();
        ASSERT_TRUE(recorder.open().has_value());
        recorder.close();
        const auto sessions = readSessionLog(path);
        ASSERT_EQ(sessions->size(), 2U);
        EXPECT_TRUE(sessions->front().events.empty()) << torn;
    }
}

TEST_F(RecorderTest, FullDiskEndsTheRecordingNotTheWork) {
    auto second_pair = makeMemoryPair(clock);
    auto& other_end = *second_pair.second;
    Recorder doomed(std::move(second_pair.first), clock, QStringLiteral("/dev/full"));
    LinkProbe doomed_probe(doomed);
    ASSERT_TRUE(doomed.open().has_value());
    ASSERT_TRUE(other_end.open().has_value());
    other_end.write(">");
    clock.advance(1s);
    EXPECT_EQ(doomed_probe.received, ">");
    EXPECT_FALSE(doomed.isRecording());
}

}  // namespace
}  // namespace pmts::transport
