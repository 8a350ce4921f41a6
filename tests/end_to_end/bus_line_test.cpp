#include "pmts/core/virtual_clock.hpp"
#include "pmts/instrument/instrument_connection.hpp"
#include "pmts/simulator/bus_station.hpp"
#include "pmts/transport/memory_link.hpp"
#include "support/matchers.hpp"
#include "support/run_to_end.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace pmts::end_to_end {
namespace {

using namespace std::chrono_literals;
using core::ErrorKind;

protocol::InstructionTable shippedTable() {
    std::ifstream file(PMTS_TEST_DATA "/../../resources/instructions/geodimeter-bus.txt");
    std::stringstream text;
    text << file.rdbuf();
    return protocol::readInstructionTable(text.str());
}

transport::MemoryPairSettings badLine(double share) {
    transport::MemoryPairSettings settings;
    settings.second_to_first = {.seed = 5, .lost = share / 2, .garbled = share / 2};
    return settings;
}

/// The connection and the simulated base at both ends of a line in memory, on one virtual clock.
class BusBench {
public:
    explicit BusBench(simulator::BusStationSettings settings = {}, transport::MemoryPairSettings line_settings = {})
        : quality(line_settings),
          station((truth->place({.ha = core::Angle::fromGon(177.56115), .va = core::Angle::fromGon(96.16838)}), settings), truth,
                  clock) {
        station.send = [this](std::string_view bytes) {
            if (wire.second) {
                wire.second->write(bytes);
            }
        };
        connection.bus()->on_step = [this](const instrument::StepOutcome& step) { steps.push_back(step); };
    }
    std::unique_ptr<transport::ByteLink> makeLink() {
        wire = transport::makeMemoryPair(clock, quality);
        wire.second->on_received = [this](std::string_view bytes) { station.receive(bytes); };
        EXPECT_TRUE(wire.second->open().has_value());
        return std::move(wire.first);
    }
    template <class T>
    core::Result<T> run(core::Task<core::Result<T>> task, core::Duration limit = 5min) {
        auto outcome = test::runToEnd(std::move(task), clock, limit);
        EXPECT_TRUE(outcome.has_value()) << "it never ended";
        return outcome ? *outcome : core::Result<T>(core::cancelled());
    }
    core::Result<instrument::Identity> connect() { return run(connection.connectTo(QStringLiteral("bus"))); }
    core::Result<instrument::RoutineOutcome> routine(const char* name, std::map<std::string, double> numbers = {}) {
        return run(connection.bus()->run(*table.find(name), std::move(numbers), stop.get_token()));
    }

    static instrument::ConnectionSettings onTheBus() {
        instrument::ConnectionSettings settings;
        settings.dialect = instrument::LineDialect::kBus;
        return settings;
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    std::shared_ptr<simulator::TruePointing> truth = std::make_shared<simulator::TruePointing>();
    transport::MemoryPairSettings quality;
    transport::MemoryPair wire;
    simulator::BusStation station;
    protocol::InstructionTable table = shippedTable();
    std::vector<instrument::StepOutcome> steps;
    std::stop_source stop;
    instrument::InstrumentConnection connection{[this](const QString&) { return makeLink(); }, clock, gate, onTheBus()};
};

TEST(BusLine, IsConnectedWhenItsStreamComesAndShowsTheTruth) {
    BusBench bench;
    ASSERT_TRUE(bench.connect().has_value());
    const auto read = bench.run(bench.connection.bus()->readPointing({}));
    ASSERT_TRUE(read.has_value());
    EXPECT_DOUBLE_EQ(read->ha.gon(), 177.56115);
    EXPECT_DOUBLE_EQ(read->va.gon(), 96.16838);
    EXPECT_EQ(bench.connection.line().counts().unsolicited, 0U);
}

TEST(BusLine, WithoutAStreamNobodyIsThere) {
    BusBench bench({.streams_at_start = false});
    EXPECT_THAT(bench.connect(), test::FailedWith(ErrorKind::kTimeOut));
}

TEST(BusLine, ThePublishedProgramSwitchesTheLaserOnBesideTheStream) {
    for (const auto meaning : {simulator::Label102::kSuspendsStream, simulator::Label102::kTakesControl, simulator::Label102::kNothing}) {
        BusBench bench({.label_102 = meaning});
        ASSERT_TRUE(bench.connect().has_value());
        const auto outcome = bench.routine("laser_on");
        ASSERT_TRUE(outcome.has_value()) << outcome.error().sentence().toStdString();
        EXPECT_TRUE(bench.station.isLaserOn());
        EXPECT_EQ(outcome->steps[2].verdict, instrument::StepVerdict::kMissing);
    }
}

TEST(BusLine, TheThirdReplyMayComeToo) {
    BusBench bench({.third_reply_missing = false});
    ASSERT_TRUE(bench.connect().has_value());
    const auto outcome = bench.routine("laser_on");
    ASSERT_TRUE(outcome.has_value());
    EXPECT_EQ(outcome->steps[2].verdict, instrument::StepVerdict::kExpected);
}

TEST(BusLine, EveryModeThereIsCanBeChosen) {
    BusBench bench;
    ASSERT_TRUE(bench.connect().has_value());
    for (const int mode : {4, 2, 0}) {
        ASSERT_TRUE(bench.routine("measuring_mode", {{"mode", mode}}).has_value());
        EXPECT_EQ(bench.station.mode(), mode);
    }
}

TEST(BusLine, TheReadingIsStaleASecondAfterTheStreamIsSuspended) {
    BusBench bench;
    ASSERT_TRUE(bench.connect().has_value());
    auto table = protocol::readInstructionTable("routine suspend\nsend WV,102=0\nexpect 0.8\n");
    ASSERT_TRUE(bench.run(bench.connection.bus()->run(table.routines[0], {}, {})).has_value());
    bench.clock.advance(900ms);
    EXPECT_TRUE(bench.run(bench.connection.bus()->readPointing({})).has_value());
    bench.clock.advance(200ms);
    EXPECT_THAT(bench.run(bench.connection.bus()->readPointing({})), test::FailedWith(ErrorKind::kTimeOut));
}

TEST(BusLine, AFailureGivesTheStreamBack) {
    for (const char* fault : {"silent,on=PV", "garble,on=PV", "info=248,on=PV", "half_block,on=PV"}) {
        BusBench bench;
        ASSERT_TRUE(bench.connect().has_value());
        ASSERT_TRUE(bench.station.injectFault(QString::fromLatin1(fault)).has_value());
        EXPECT_FALSE(bench.routine("laser_on").has_value()) << fault;
        bench.clock.advance(2s);
        EXPECT_TRUE(bench.run(bench.connection.bus()->readPointing({})).has_value()) << fault;
        EXPECT_EQ(bench.steps.back().sent, "WV,102=1\r");
    }
}

TEST(BusLine, ADoubledOrLateReplyIsNobodyElsesAnswer) {
    for (const char* fault : {"twice,on=PV", "late=2,on=PV"}) {
        BusBench bench;
        ASSERT_TRUE(bench.connect().has_value());
        ASSERT_TRUE(bench.station.injectFault(QString::fromLatin1(fault)).has_value());
        const auto outcome = bench.routine("laser_on");
        EXPECT_TRUE(outcome.has_value()) << fault << ": " << outcome.error().sentence().toStdString();
    }
}

TEST(BusLine, OnALossyLineNoReadingIsWrongAndTheLaserIsOnWhenItSaysSo) {
    BusBench bench({}, badLine(0.02));
    ASSERT_TRUE(bench.connect().has_value());
    int readings = 0;
    bench.connection.bus()->on_pointing = [&](const geometry::Pointing& pointing, core::Duration) {
        ++readings;
        EXPECT_NEAR(pointing.ha.gon(), 177.56115, 0.002);  // a change within the noise of a reading is not seen
        EXPECT_NEAR(pointing.va.gon(), 96.16838, 0.002);
    };
    for (int i = 0; i < 20; ++i) {
        const auto outcome = bench.routine("laser_on");
        EXPECT_TRUE(!outcome || bench.station.isLaserOn());
        bench.clock.advance(20s);
    }
    EXPECT_GT(readings, 400);
}

TEST(BusLine, WhatThePageDoesNotDiscloseIsRefused) {
    BusBench bench;
    ASSERT_TRUE(bench.connect().has_value());
    EXPECT_THAT(bench.run(bench.connection.speaker().measureDistance({})), test::FailedWith(ErrorKind::kUnsupported));
    EXPECT_THAT(bench.run(bench.connection.speaker().turnTo({}, {}, {})), test::FailedWith(ErrorKind::kUnsupported));
}

TEST(BusLine, TheLineIsFoundAgainAfterALoss) {
    BusBench bench;
    ASSERT_TRUE(bench.connect().has_value());
    bench.wire.second->unplug();
    core::deliverQueuedEvents();
    EXPECT_EQ(bench.connection.state(), instrument::ConnectionState::kLost);
}

TEST(BusLine, ABaseThatFallsSilentOnAnOpenPortIsLostAndComesBack) {
    BusBench bench;
    ASSERT_TRUE(bench.connect().has_value());
    QString sentence;
    bench.connection.on_state = [&](instrument::ConnectionState, const QString& said) { sentence = said; };
    ASSERT_TRUE(bench.station.injectFault(QStringLiteral("power_off=20")).has_value());
    bench.clock.advance(2s);
    EXPECT_EQ(bench.connection.state(), instrument::ConnectionState::kConnected);
    bench.clock.advance(2s);
    EXPECT_EQ(bench.connection.state(), instrument::ConnectionState::kLost);
    EXPECT_TRUE(sentence.contains(QStringLiteral("silent"))) << sentence.toStdString();
    bench.clock.advance(30s);
    EXPECT_EQ(bench.connection.state(), instrument::ConnectionState::kConnected);
}

TEST(BusLine, ARoutineThatSuspendsTheStreamForLongIsNoSilence) {
    BusBench bench;
    ASSERT_TRUE(bench.connect().has_value());
    const auto table = protocol::readInstructionTable(
        "routine long\nsend WV,102=0\nexpect 0.8\npause 10\nsend WV,102=1\nexpect 0.8\nalways\n");
    ASSERT_TRUE(table.problems.empty());
    std::vector<instrument::ConnectionState> states;
    bench.connection.on_state = [&](instrument::ConnectionState state, const QString&) { states.push_back(state); };
    EXPECT_TRUE(bench.run(bench.connection.bus()->run(table.routines[0], {}, {})).has_value());
    bench.clock.advance(10s);
    EXPECT_TRUE(states.empty());
}

TEST(BusLine, ADisconnectedBusSaysNothingOfItsSilence) {
    BusBench bench;
    ASSERT_TRUE(bench.connect().has_value());
    bench.connection.disconnect();
    bench.clock.advance(10s);
    EXPECT_EQ(bench.connection.state(), instrument::ConnectionState::kDisconnected);
}

TEST(BusLine, WhileThePanelHasTheLineItsPortStaysOpenInTheSilence) {
    BusBench bench;
    ASSERT_TRUE(bench.connect().has_value());
    bench.connection.setControlMode(scheduler::ControlMode::kPanel);
    ASSERT_TRUE(bench.station.injectFault(QStringLiteral("power_off=10")).has_value());
    bench.clock.advance(8s);
    EXPECT_EQ(bench.connection.state(), instrument::ConnectionState::kConnected);
    bench.clock.advance(10s);
    bench.connection.setControlMode(scheduler::ControlMode::kShared);
    bench.clock.advance(10s);
    EXPECT_EQ(bench.connection.state(), instrument::ConnectionState::kConnected);
}

}  // namespace
}  // namespace pmts::end_to_end
