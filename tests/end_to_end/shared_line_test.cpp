#include "driver_bench.hpp"
#include "pmts/instrument/instrument_connection.hpp"
#include "pmts/simulator/control_unit.hpp"

namespace pmts::end_to_end {
namespace {

using instrument::ConnectionState;
using scheduler::ControlMode;

/// PMTS between a simulated instrument and a simulated control unit, all three at 9600 baud on one virtual clock. The
/// control unit checks every answer itself.
class SharedInstrumentTest : public testing::TestWithParam<unsigned> {
protected:
    SharedInstrumentTest() {
        unit.send = [this](std::string_view bytes) { panel_wire.second->write(bytes); };
        unit.on_foreign = [](const QString& sentence) { ADD_FAILURE() << sentence.toStdString(); };
        EXPECT_TRUE(panel_wire.second->open().has_value());
        connection.usePanel([this] {
            panel_wire = transport::makeMemoryPair(clock);
            panel_wire.second->on_received = [this](std::string_view bytes) { unit.receive(bytes); };
            EXPECT_TRUE(panel_wire.second->open().has_value());
            return std::move(panel_wire.first);
        });
        unit.start();
    }

    std::unique_ptr<transport::ByteLink> makeWire() {
        wire = transport::makeMemoryPair(clock);
        wire.second->on_received = [this](std::string_view bytes) { station.receive(bytes); };
        station.send = [this](std::string_view bytes) { wire.second->write(bytes); };
        EXPECT_TRUE(wire.second->open().has_value());
        return std::move(wire.first);
    }
    template <class T>
    core::Result<T> run(core::Task<core::Result<T>> task) {
        auto outcome = test::runToEnd(std::move(task), clock, 10min);
        return outcome ? *outcome : core::Result<T>(core::cancelled());
    }
    void connect() { ASSERT_TRUE(run(connection.connectTo(QStringLiteral("wire"))).has_value()); }
    static simulator::ControlUnitSettings unitSettings() {
        simulator::ControlUnitSettings settings;
        settings.seed = GetParam();
        return settings;
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    std::shared_ptr<const simulator::Scene> scene = sharedYard();
    std::shared_ptr<simulator::TruePointing> truth = std::make_shared<simulator::TruePointing>();
    simulator::Station station{{}, scene, truth, clock};
    simulator::ControlUnit unit{unitSettings(), clock};
    transport::MemoryPair wire, panel_wire = transport::makeMemoryPair(clock);
    instrument::InstrumentConnection connection{[this](const QString&) { return makeWire(); }, clock, gate};
};

TEST_P(SharedInstrumentTest, TheControlUnitGetsExactlyItsAnswersWhilePmtsPolls) {
    connect();
    clock.advance(10min);

    EXPECT_GT(unit.counts().asked, 500U);
    EXPECT_EQ(unit.counts().foreign, 0U);
    EXPECT_EQ(unit.counts().unanswered, 0U);
    EXPECT_EQ(connection.line().counts().unsolicited, 0U);
    EXPECT_EQ(connection.line().counts().timed_out, 0U);
    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
}

TEST_P(SharedInstrumentTest, PmtsTurnsWhileTheControlUnitWorks) {
    connect();
    for (int i = 0; i < 20; ++i) {
        const geometry::Pointing target{.ha = Angle::fromGon(20.0 + 7 * i), .va = Angle::fromGon(95)};
        const auto arrived = run(connection.station().turnTo(target, Angle::fromCc(5), {}));
        ASSERT_TRUE(arrived.has_value()) << testing::PrintToString(arrived.error());
        EXPECT_THAT(truth->at(clock.now()).ha, test::IsNearAngle(target.ha, Angle::fromCc(10)));
    }
    EXPECT_GT(unit.counts().answered, 15U);  // it waits while the motors run
    EXPECT_EQ(unit.counts().foreign + unit.counts().unanswered, 0U);
}

TEST_P(SharedInstrumentTest, DistancesAreRightOrSaidToBeMissingWhileTheControlUnitMeasuresToo) {
    connect();
    const geometry::Pointing target{.ha = Angle::fromGon(10), .va = Angle::fromGon(100)};
    ASSERT_TRUE(run(connection.station().turnTo(target, Angle::fromCc(5), {})).has_value());
    const double truth_m = scene->echo(truth->at(clock.now()))->distance_m;
    int measured = 0;
    for (int i = 0; i < 20; ++i) {
        const auto shot = run(connection.station().measureDistance({}));
        measured += shot ? 1 : 0;
        if (shot) {
            EXPECT_NEAR(shot->slope_distance_m, truth_m, 5 * 0.0032);  // five sigma of the distance meter
        } else {
            EXPECT_FALSE(shot.error().happened.isEmpty());
        }
    }
    EXPECT_GE(measured, 15);
    EXPECT_EQ(unit.counts().foreign, 0U);
}

TEST_P(SharedInstrumentTest, ModesChangeUnderLoadAndNothingIsMixedUp) {
    connect();
    for (const auto mode : {ControlMode::kPanel, ControlMode::kShared, ControlMode::kPanel, ControlMode::kShared}) {
        connection.setControlMode(mode);
        clock.advance(2min);
        EXPECT_EQ(connection.control().mode, mode);
    }
    EXPECT_GT(unit.counts().answered, 200U);
    EXPECT_EQ(unit.counts().foreign + unit.counts().unanswered, 0U);
    EXPECT_TRUE(connection.poller().isRunning());
}

TEST_P(SharedInstrumentTest, InComputerModeTheControlUnitHearsNothing) {
    connect();
    connection.setControlMode(ControlMode::kComputer);
    clock.advance(1s);
    const auto before = unit.counts().answered;
    clock.advance(5min);

    EXPECT_EQ(unit.counts().answered, before);
    EXPECT_EQ(unit.counts().foreign, 0U);
    EXPECT_GT(connection.control().counts.swallowed, 2U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SharedInstrumentTest, testing::Values(1U, 7U, 42U));

}  // namespace
}  // namespace pmts::end_to_end
