#include "pmts/transport/memory_link.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "support/matchers.hpp"
#include "transport/link_probe.hpp"

#include <bit>

namespace pmts::transport {
namespace {

using namespace std::chrono_literals;
using core::Duration;
using core::ErrorKind;
using test::FailedWith;
using test::LinkProbe;

struct OpenPair {
    explicit OpenPair(core::Clock& clock, MemoryPairSettings settings = {})
        : pair(makeMemoryPair(clock, settings)) {
        EXPECT_TRUE(pair.first->open().has_value());
        EXPECT_TRUE(pair.second->open().has_value());
    }

    MemoryPair pair;
    LinkProbe first{*pair.first};
    LinkProbe second{*pair.second};
};

class MemoryLinkTest : public testing::Test {
protected:
    core::VirtualClock clock;
};

TEST_F(MemoryLinkTest, BytesArriveThroughTheEventLoopNotInsideWrite) {
    OpenPair line(clock);
    line.pair.first->write("RG\r");
    line.pair.second->write("0\r\n>");
    EXPECT_EQ(line.second.received, "");
    core::deliverQueuedEvents();
    EXPECT_EQ(line.second.received, "RG\r");
    EXPECT_EQ(line.first.received, "0\r\n>");
}

TEST_F(MemoryLinkTest, NineThousandSixHundredBaudTakesOneMillisecondAByte) {
    OpenPair line(clock, {.baud = 9600.0, .first_to_second = {}, .second_to_first = {}});
    std::vector<Duration> arrivals;
    line.pair.second->on_received = [&](std::string_view bytes) {
        arrivals.insert(arrivals.end(), bytes.size(), clock.now());
    };
    line.pair.first->write("WG,26=96.1684\r");  // 14 bytes
    clock.advance(1s);
    ASSERT_EQ(arrivals.size(), 14U);
    EXPECT_NEAR(std::chrono::duration<double>(arrivals.front()).count(), 0.0010417, 1e-7);
    EXPECT_NEAR(std::chrono::duration<double>(arrivals.back()).count(), 14 * 0.00104167, 1e-7);
}

TEST_F(MemoryLinkTest, SecondWriteWaitsForTheFirstOnASlowLine) {
    OpenPair line(clock, {.baud = 1000.0, .first_to_second = {}, .second_to_first = {}});
    line.pair.first->write("TG\r");
    line.pair.first->write("RG\r");
    clock.advance(30ms);
    EXPECT_EQ(line.second.received, "TG\r");
    clock.advance(30ms);
    EXPECT_EQ(line.second.received, "TG\rRG\r");
}

TEST_F(MemoryLinkTest, UnpluggingIsReportedOnceToEachEnd) {
    OpenPair line(clock);
    line.pair.first->write("RG\r");
    line.pair.second->unplug();
    line.pair.second->unplug();
    EXPECT_TRUE(line.first.losses.empty()) << "reported inside the call";
    clock.advance(1s);
    ASSERT_EQ(line.first.losses.size(), 1U);
    EXPECT_EQ(line.first.losses[0].kind, ErrorKind::kLinkLost);
    EXPECT_EQ(line.second.losses.size(), 1U);
    EXPECT_EQ(line.second.received, "") << "bytes on the way are lost";
    EXPECT_FALSE(line.pair.first->isOpen());
}

TEST_F(MemoryLinkTest, PluggedInAgainTheLineWorksAgain) {
    OpenPair line(clock);
    line.pair.first->unplug();
    clock.advance(1s);
    EXPECT_THAT(line.pair.first->open(), FailedWith(ErrorKind::kPortUnavailable));
    line.pair.first->plug();
    ASSERT_TRUE(line.pair.first->open().has_value());
    ASSERT_TRUE(line.pair.second->open().has_value());
    line.pair.second->write(">");
    clock.advance(1s);
    EXPECT_EQ(line.first.received, ">");
}

TEST_F(MemoryLinkTest, ClosedEndHearsNothingAndLosesNothing) {
    OpenPair line(clock);
    line.pair.second->close();
    line.pair.first->write("RG\r");
    line.pair.first->unplug();
    clock.advance(1s);
    EXPECT_EQ(line.second.received, "");
    EXPECT_TRUE(line.second.losses.empty());
}

TEST_F(MemoryLinkTest, OneEndMayGoAwayInsideItsOwnCallback) {
    OpenPair line(clock);
    line.pair.second->on_received = [&](std::string_view) { line.pair.second.reset(); };
    line.pair.first->write("RG\r");
    clock.advance(1s);
    EXPECT_EQ(line.pair.second, nullptr);
    line.pair.first->write("RG\r");
    clock.advance(1s);
}

std::string throughBadLine(core::VirtualClock& clock, const LineFaults& faults, const std::string& sent) {
    OpenPair line(clock, {.baud = std::nullopt, .first_to_second = faults, .second_to_first = {}});
    line.pair.first->write(sent);
    clock.advance(10s);
    return line.second.received;
}

TEST_F(MemoryLinkTest, LostBytesAreAsManyAsAskedForAndTheSameForTheSameSeed) {
    const std::string sent(20000, 'x');
    const auto arrived = throughBadLine(clock, {.seed = 3, .lost = 0.05}, sent).size();
    EXPECT_NEAR(static_cast<double>(arrived), 19000.0, 150.0);  // 5 sigma
    EXPECT_EQ(throughBadLine(clock, {.seed = 3, .lost = 0.05}, sent).size(), arrived);
    EXPECT_NE(throughBadLine(clock, {.seed = 4, .lost = 0.05}, sent).size(), arrived);
}

TEST_F(MemoryLinkTest, GarbledBytesDifferInOneBitAndDoubledOnesComeTwice) {
    const std::string garbled = throughBadLine(clock, {.seed = 5, .garbled = 1.0}, "RG\r");
    ASSERT_EQ(garbled.size(), 3U);
    EXPECT_EQ(std::popcount(static_cast<unsigned char>(garbled[0] ^ 'R')), 1);
    EXPECT_EQ(throughBadLine(clock, {.seed = 5, .doubled = 1.0}, "RG\r"), "RRGG\r\r");
}

TEST_F(MemoryLinkTest, LateAnswerIsNeverOvertaken) {
    OpenPair line(
        clock,
        {.baud = std::nullopt, .first_to_second = {.late = 1.0, .late_by = 2s}, .second_to_first = {}});
    line.pair.first->write("a");
    line.pair.first->write("b");
    clock.advance(1s);
    EXPECT_EQ(line.second.received, "");
    clock.advance(10s);
    EXPECT_EQ(line.second.received, "ab");
}

}  // namespace
}  // namespace pmts::transport
