#include "pmts/app/desk/probe_presenter.hpp"

#include "field_fixture.hpp"
#include "pmts/app/desk/connection_checks.hpp"
#include "pmts/simulator/bus_station.hpp"
#include "pmts/simulator/line_framing.hpp"
#include "support/run_until.hpp"

namespace pmts::app {
namespace {

using simulator::LineFraming;

LineFraming framing(const char* text) { return *LineFraming::fromText(QString::fromLatin1(text)); }

LineFraming framingOf(const transport::SerialSettings& line) {
    return {.baud = line.baud,
            .data_bits = line.data_bits,
            .parity = static_cast<simulator::WireParity>(line.parity),
            .stop_bits = line.stop_bits};
}

/// The simulated instrument at the end of a wire whose bits are what both ends make of them.
class ProbeTest : public FieldTest {
protected:
    std::unique_ptr<transport::ByteLink> makeWire(const LineFraming& theirs) {
        auto pair = transport::makeMemoryPair(clock);
        far_end = std::move(pair.second);
        (void)far_end->open();
        far_end->on_received = [this, theirs](std::string_view bytes) {
            if (base) {
                base->receive(heardAs(bytes, theirs, own));
            } else if (!is_off) {
                station.receive(heardAs(bytes, theirs, own));
            }
        };
        station.send = [this, theirs](std::string_view bytes) { far_end->write(heardAs(bytes, own, theirs)); };
        if (base) {
            base->send = station.send;
        }
        return std::move(pair.first);
    }
    ProbeWiring probeWiring() {
        return {.threading = Threading::kCallersThread, .clock = &clock,
                .make_link = [this](const transport::SerialSettings& line) { return makeWire(framingOf(line)); }};
    }
    InstrumentWiring wireWiring() {
        auto wires = wiring();
        wires.make_link = [this](const SerialChoice& choice) {
            return makeWire({.baud = choice.baud,
                             .data_bits = choice.data_bits,
                             .parity = static_cast<simulator::WireParity>(choice.parity),
                             .stop_bits = choice.stop_bits});
        };
        return wires;
    }
    static SerialChoice wire(int baud = 9600) {
        SerialChoice choice;
        choice.path = QStringLiteral("wire");
        choice.baud = baud;
        return choice;
    }
    void TearDown() override {
        desk.disconnectInstrument();
        FieldTest::TearDown();
    }
    void look() {
        probe.start({QStringLiteral("wire")});
        ASSERT_TRUE(until([this] { return !probe.isRunning(); }, 300s));
    }

    LineFraming own = framing("4800-8N1");
    bool is_off = false;
    std::optional<simulator::BusStation> base;  ///< instead of the station
    std::unique_ptr<transport::MemoryLink> far_end;
    InstrumentDesk desk{gate, wireWiring()};
    SimulationDesk simulation;
    ConnectionPresenter connection{desk, simulation, live, gate, preferences, messages, [] {
                                       return std::vector<video::SourceAddress>();
                                   }};
    ConnectionChecks checks{desk};
    ProbePresenter probe{connection, desk, simulation, probeWiring()};
};

class ProbeSettingTest : public ProbeTest, public testing::WithParamInterface<const char*> {};

TEST_P(ProbeSettingTest, FindsTheInstrumentAtItsOwnSettingAndConnectsThere) {
    own = framing(GetParam());
    look();
    ASSERT_TRUE(probe.found().has_value()) << probe.verdict().text.toStdString();
    EXPECT_EQ(QStringLiteral("%1-%2").arg(probe.found()->baud).arg(probe.found()->framing().text()), QString::fromLatin1(GetParam()));
    EXPECT_EQ(probe.verdict().state, DeviceState::kGood) << probe.verdict().details.toStdString();
    probe.useFound();
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnected; }, 60s));
    EXPECT_EQ(desk.identity()->serial_number, QStringLiteral("620123"));
}

INSTANTIATE_TEST_SUITE_P(OfThePage, ProbeSettingTest,
                         testing::Values("9600-8N1", "4800-8N1", "19200-8N1", "300-8N1", "9600-7E1", "4800-7O1", "2400-8E1",
                                         "1200-8O1"));

TEST_F(ProbeTest, SaysWhatIsTriedNowAndHowFarItIs) {
    own = framing("300-8O1");
    probe.start({QStringLiteral("wire")});
    ASSERT_TRUE(until([this] { return probe.fraction() > 0.2; }));
    EXPECT_TRUE(probe.stepText().startsWith(QStringLiteral("wire at "))) << probe.stepText().toStdString();
    EXPECT_TRUE(probe.stepText().endsWith(QStringLiteral("of 36)")));
    probe.cancel();
    ASSERT_TRUE(until([this] { return !probe.isRunning(); }, 1s));
    EXPECT_EQ(probe.verdict().text, QStringLiteral("The search was ended."));
    EXPECT_FALSE(probe.found().has_value());
}

TEST_F(ProbeTest, ASwitchedOffInstrumentIsSaidAsSilence) {
    is_off = true;
    look();
    EXPECT_EQ(probe.verdict().state, DeviceState::kFailed);
    EXPECT_TRUE(probe.verdict().text.contains(QStringLiteral("No byte comes")));
    EXPECT_TRUE(probe.verdict().details.contains(QStringLiteral("Switch the instrument on")));
}

TEST_F(ProbeTest, AConnectedInstrumentIsNotDisturbed) {
    desk.connectSerial(wire(4800));
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnected; }));
    EXPECT_FALSE(probe.refusal().isEmpty());
    probe.start({QStringLiteral("wire")});
    EXPECT_FALSE(probe.isRunning());
    EXPECT_EQ(desk.connectionState(), ConnectionState::kConnected);
}

TEST_F(ProbeTest, AnAttemptToConnectGivesItsPortAwayFirst) {
    desk.connectSerial(wire());
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnecting; }));
    look();
    EXPECT_EQ(desk.connectionState(), ConnectionState::kDisconnected);
    EXPECT_TRUE(probe.found().has_value());
}

TEST_F(ProbeTest, ABusIsFoundAsABusAndConnectedAsOne) {
    own = framing("4800-8N1");
    base.emplace(simulator::BusStationSettings{}, true_pointing, clock);
    look();
    EXPECT_EQ(probe.verdict().state, DeviceState::kGood) << probe.verdict().text.toStdString();
    EXPECT_TRUE(probe.verdict().text.contains(QStringLiteral("bus under the panel"))) << probe.verdict().text.toStdString();
    ASSERT_TRUE(probe.found().has_value());
    EXPECT_EQ(probe.found()->dialect, instrument::LineDialect::kBus);
    EXPECT_EQ(probe.found()->baud, 4800);
    probe.useFound();
    EXPECT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnected; }, 60s));
}

TEST_F(ProbeTest, NoTickedPortIsSaid) {
    probe.start({});
    EXPECT_FALSE(probe.isRunning());
    EXPECT_EQ(probe.verdict().text, QStringLiteral("No port is chosen."));
}

// The check list ------------------------------------------------------------------------------------------------------

TEST_F(ProbeTest, TheCheckListIsGreenFromPortToOutputWhenConnected) {
    desk.connectSerial(wire(4800));
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnected; }));
    for (const CheckItem& item : checks.items()) {
        EXPECT_EQ(item.state, DeviceState::kGood) << item.title.toStdString() << ": " << item.sentence.toStdString();
    }
    EXPECT_TRUE(checks.items()[ConnectionChecks::kEndMark].sentence.contains(QStringLiteral("79 = 62")));
    EXPECT_TRUE(checks.items()[ConnectionChecks::kUnits].sentence.contains(QStringLiteral("1111")));
    EXPECT_TRUE(checks.items()[ConnectionChecks::kSerialNumber].sentence.contains(QStringLiteral("620123")));
}

/// What an instrument hears at another speed has no end of line: it says nothing.
TEST_F(ProbeTest, WrongSpeedIsNamedInTheCheckList) {
    own = framing("19200-8N1");
    desk.connectSerial(wire());
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kDisconnected; }));
    const auto& items = checks.items();
    EXPECT_EQ(items[ConnectionChecks::kPort].state, DeviceState::kGood);
    EXPECT_EQ(items[ConnectionChecks::kBytes].state, DeviceState::kFailed);
    EXPECT_TRUE(items[ConnectionChecks::kBytes].sentence.endsWith(
        QStringLiteral("At another speed it is silent too: \"Look for the settings\" tries them.")))
        << items[ConnectionChecks::kBytes].sentence.toStdString();
    EXPECT_EQ(items[ConnectionChecks::kGrammar].state, DeviceState::kIdle) << "nothing came that could be judged";
    EXPECT_EQ(items[ConnectionChecks::kEndMark].state, DeviceState::kIdle) << "nothing is known of it";
}

/// One that sends by itself at another speed is heard, and its bytes are no text.
TEST_F(ProbeTest, BytesOfAnotherSpeedAreNamedInTheCheckList) {
    own = framing("19200-8N1");
    desk.connectSerial(wire());
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnecting; }));
    for (int i = 0; i < 40 && desk.connectionState() == ConnectionState::kConnecting; ++i) {
        station.pressRegKey();
        pass(500ms);
    }
    ASSERT_EQ(desk.connectionState(), ConnectionState::kDisconnected);
    EXPECT_EQ(checks.items()[ConnectionChecks::kGrammar].state, DeviceState::kFailed);
    EXPECT_EQ(checks.items()[ConnectionChecks::kGrammar].sentence,
              QStringLiteral("The bytes are no text: speed or framing differ (label 78). \"Look for the settings\" finds them."));
}

TEST_F(ProbeTest, AMissingEndMarkIsAWarningWithItsRemedy) {
    desk.connectSerial(wire(4800));
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnected; }));
    desk.writeLabel(79, QStringLiteral("0"));
    pass(5s);
    desk.connectSerial(wire(4800));
    ASSERT_TRUE(until([this] { return checks.items()[ConnectionChecks::kSerialNumber].state == DeviceState::kGood; }));
    EXPECT_EQ(checks.items()[ConnectionChecks::kEndMark].state, DeviceState::kWarning)
        << checks.items()[ConnectionChecks::kEndMark].sentence.toStdString();
}

TEST_F(ProbeTest, APressedRegKeyShowsThatTheOutputIsNotRequest) {
    desk.connectSerial(wire(4800));
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnected; }));
    far_end->write("0\r\n7=10.2345\r\n8=101.1005\r\n>");
    pass(2s);
    EXPECT_EQ(checks.items()[ConnectionChecks::kOutput].state, DeviceState::kWarning);
}

// The whole way over a real pty ---------------------------------------------------------------------------------------

TEST(ProbeOverPtyTest, FindsTheSpeedOfTheSimulatedInstrumentOverARealPort) {
    core::SystemClock clock;
    SimulationDesk simulation;
    SimulationChoice choice;
    choice.line = QStringLiteral("4800-8N1");
    simulation.start(choice);
    ASSERT_TRUE(test::runUntil([&] { return simulation.isRunning() && !simulation.portPath().isEmpty(); }));

    std::optional<core::Result<instrument::ProbeOutcome>> outcome;
    instrument::LineProbe probe([](const transport::SerialSettings& line) { return std::make_unique<transport::SerialLink>(line); },
                                clock);
    const auto look = [](instrument::LineProbe& with, QString port,
                         std::optional<core::Result<instrument::ProbeOutcome>>& to) -> core::Task<void> {
        auto running = with.run({port}, {});
        to = co_await running;
    };
    look(probe, simulation.portPath(), outcome);
    ASSERT_TRUE(test::runUntil([&] { return outcome.has_value(); }, 3min));  // 36 settings of half a second and more

    ASSERT_TRUE(outcome->has_value());
    const instrument::ProbedPort& shown = outcome->value().ports.at(0);
    ASSERT_TRUE(outcome->value().found.has_value()) << (shown.trouble ? shown.trouble->sentence().toStdString() : shown.heard);
    EXPECT_EQ(outcome->value().found->line.lineText(), QStringLiteral("4800 8N1"));
    EXPECT_EQ(outcome->value().found->evidence.label_79, 62);
}

}  // namespace
}  // namespace pmts::app
