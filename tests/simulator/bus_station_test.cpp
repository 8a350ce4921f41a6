#include "pmts/core/virtual_clock.hpp"
#include "pmts/protocol/reply.hpp"
#include "pmts/simulator/bus_station.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pmts::simulator {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

class BusStationTest : public testing::Test {
protected:
    void start(BusStationSettings settings = {}) {
        truth->place({.ha = core::Angle::fromGon(177.56115), .va = core::Angle::fromGon(96.16838)});
        station = std::make_unique<BusStation>(settings, truth, clock);
        station->send = [this](std::string_view bytes) { heard += bytes; };
    }
    /// What comes within a second, block by block, without the stream.
    std::vector<std::string> ask(const std::string& command, core::Duration within = 1s) {
        heard.clear();
        station->receive(command + "\r");
        clock.advance(within);
        std::vector<std::string> replies;
        for (auto& block : protocol::BlockReader('\x04').feed(heard)) {
            if (!block.starts_with("A,")) {
                replies.push_back(block.substr(0, block.find('\r')));
            }
        }
        return replies;
    }
    [[nodiscard]] int streamBlocks() const {
        int count = 0;
        for (auto at = heard.find("A,166="); at != std::string::npos; at = heard.find("A,166=", at + 1)) {
            ++count;
        }
        return count;
    }

    core::VirtualClock clock;
    std::shared_ptr<TruePointing> truth = std::make_shared<TruePointing>();
    std::unique_ptr<BusStation> station;
    std::string heard;
};

TEST_F(BusStationTest, TheStreamIsThePublishedBlock) {
    start();
    clock.advance(340ms);
    EXPECT_EQ(heard, "A,166=96.16838\rA,165=177.56115\x04");
    clock.advance(10s - 340ms);
    EXPECT_EQ(streamBlocks(), 33);
}

TEST_F(BusStationTest, TheStreamFollowsTheTruePointingAndNeverShows400) {
    start({.baud = 0.0});
    truth->place({.ha = core::Angle::fromGon(399.999999), .va = core::Angle::fromGon(100.0)});
    clock.advance(298ms);
    EXPECT_EQ(heard, "A,166=100.00000\rA,165=0.00000\x04");
}

TEST_F(BusStationTest, ThePublishedProgramIsAnsweredAsItWasSeen) {
    start();
    EXPECT_THAT(ask("WV,102=0"), ElementsAre("0.8"));
    EXPECT_THAT(ask("PV,8=9"), ElementsAre("240.8"));
    EXPECT_FALSE(station->isLaserOn());
    EXPECT_THAT(ask("PV,4=0"), ElementsAre());
    EXPECT_TRUE(station->isLaserOn());
    EXPECT_THAT(ask("WV,102=1"), ElementsAre("0.8"));
    EXPECT_THAT(ask("WV,102=0"), ElementsAre("0.8"));
    EXPECT_THAT(ask("PV,3=0"), ElementsAre("240.8"));
    EXPECT_THAT(ask("WV,102=1"), ElementsAre("0.8"));
}

TEST_F(BusStationTest, TheMissingThirdReplyMayCome) {
    start({.third_reply_missing = false});
    EXPECT_THAT(ask("PV,4=0"), ElementsAre("240.8"));
}

TEST_F(BusStationTest, Label102SuspendsTheStreamAndResumesIt) {
    start();
    (void)ask("WV,102=0");
    heard.clear();
    clock.advance(3s);
    EXPECT_EQ(streamBlocks(), 0);
    (void)ask("WV,102=1");
    clock.advance(3s);
    EXPECT_GE(streamBlocks(), 12);
}

TEST_F(BusStationTest, Label102MayMeanControlInstead) {
    start({.label_102 = Label102::kTakesControl});
    EXPECT_THAT(ask("PV,3=1"), ElementsAre("248.8"));
    (void)ask("WV,102=0");
    EXPECT_GE(streamBlocks(), 2);
    EXPECT_THAT(ask("PV,3=1"), ElementsAre("240.8"));
    EXPECT_EQ(station->mode(), 1);
}

TEST_F(BusStationTest, WhatItDoesNotKnowIsRefusedByItsCode) {
    start();
    EXPECT_THAT(ask("PV,77=1"), ElementsAre("242.8"));
    EXPECT_THAT(ask("PV,3=5"), ElementsAre("35.8"));
    EXPECT_THAT(ask("WV,101=0"), ElementsAre("20.8"));
    EXPECT_THAT(ask("WV,102=7"), ElementsAre("35.8"));
    EXPECT_THAT(ask("wv,102=0"), ElementsAre("30.8"));
    EXPECT_THAT(ask("RA,165"), ElementsAre("165=177.56115"));
    EXPECT_THAT(ask("RV,102"), ElementsAre("102=1"));
}

TEST_F(BusStationTest, MoreThanTenWaitingCommandsAreTooMany) {
    start({.process_time = 5s});
    std::string many;
    for (int i = 0; i < 12; ++i) {
        many += "PV,3=0\r";
    }
    EXPECT_THAT(ask(many), ElementsAre("207.8"));
}

TEST_F(BusStationTest, FaultsOfTheLineStrikeTheReply) {
    start();
    const auto with = [&](const char* fault, const char* command) {
        EXPECT_TRUE(station->injectFault(QString::fromLatin1(fault)).has_value()) << fault;
        return ask(command);
    };
    EXPECT_THAT(with("silent,on=PV", "WV,102=0"), ElementsAre("0.8"));
    ASSERT_TRUE(station->injectFault(QStringLiteral("none")).has_value());
    EXPECT_THAT(with("silent", "PV,8=9"), ElementsAre());
    EXPECT_THAT(with("twice", "PV,8=9"), ElementsAre("240.8", "240.8"));
    EXPECT_THAT(with("late=3", "PV,8=9"), ElementsAre());
    EXPECT_THAT(ask("WV,102=0", 4s), ElementsAre("240.8", "0.8"));
    EXPECT_THAT(with("garble", "PV,8=9"), testing::Not(ElementsAre("240.8")));
    EXPECT_THAT(with("info=197", "PV,8=9"), ElementsAre("197.8"));
    EXPECT_FALSE(station->injectFault(QStringLiteral("level_loss")).has_value());
}

TEST_F(BusStationTest, ItsStartUpGoesThroughInOrderOnly) {
    start({.start_up = {.steps = 3}});
    EXPECT_THAT(ask("PV,30=1", 300ms), ElementsAre("240.8"));
    EXPECT_THAT(ask("PV,30=3", 300ms), ElementsAre("248.8"));
    for (const char* step : {"PV,30=1", "PV,30=2", "PV,30=3"}) {
        EXPECT_FALSE(station->isStarted());
        EXPECT_THAT(ask(step, 300ms), ElementsAre("240.8"));
    }
    EXPECT_TRUE(station->isStarted());
}

/// Steps of the start-up that went well, of a thousand, while the host draws a frame in each.
int stepsThatWentWell(double failure_per_frame) {
    core::VirtualClock clock;
    auto truth = std::make_shared<TruePointing>();
    BusStation station({.baud = 0.0, .streams_at_start = false, .start_up = {.failure_per_frame = failure_per_frame}}, truth,
                       clock);
    int well = 0;
    station.send = [&](std::string_view bytes) { well += bytes.starts_with("240.8") ? 1 : 0; };
    std::uint64_t frames = 0;
    station.frames_of_host = [&] { return frames++; };
    for (int i = 0; i < 1000; ++i) {
        station.receive("PV,30=1\r");
        clock.advance(100ms);
    }
    return well;
}

TEST(BusStartUp, FailsAsOftenAsTheHostsVideoIsSaidToDisturbIt) {
    EXPECT_EQ(stepsThatWentWell(0.0), 1000);
    EXPECT_NEAR(stepsThatWentWell(0.3), 700, 5 * 14.5);  // 5 sigma of a binomial
}

TEST_F(BusStationTest, ALateHostMakesTheStartUpFail) {
    start({.start_up = {.patience = 100ms, .failure_per_late_second = 1.0}});
    EXPECT_THAT(ask("PV,30=1", 300ms), ElementsAre("240.8"));
    clock.advance(2s);
    EXPECT_THAT(ask("PV,30=2", 300ms), ElementsAre("248.8"));
}

}  // namespace
}  // namespace pmts::simulator
