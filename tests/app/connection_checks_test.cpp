#include "pmts/app/desk/connection_checks.hpp"

#include "field_fixture.hpp"
#include "pmts/app/line/instrument_health.hpp"
#include "pmts/app/line/memory_presenter.hpp"
#include "pmts/simulator/bus_station.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

using State = DeviceState;

class ConnectionChecksTest : public FieldTest {
protected:
    [[nodiscard]] const CheckItem& item(ConnectionChecks::Check check) const { return checks.items().at(check); }

    ConnectionChecks checks{instrument};
};

TEST_F(ConnectionChecksTest, APulledCableEmptiesTheListAndFillsItAgainWhenItIsBack) {
    connectInstrument();
    ASSERT_EQ(item(ConnectionChecks::kOutput).state, State::kGood);
    unplug();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kReconnecting; }));
    EXPECT_EQ(item(ConnectionChecks::kPort).state, State::kFailed);
    EXPECT_EQ(item(ConnectionChecks::kPort).sentence, instrument.connectionSentence());
    for (const auto check : {ConnectionChecks::kGrammar, ConnectionChecks::kEndMark, ConnectionChecks::kUnits,
                             ConnectionChecks::kSerialNumber, ConnectionChecks::kOutput}) {
        EXPECT_EQ(item(check).state, State::kIdle) << item(check).title.toStdString();
    }
    plugIn();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kConnected; }));
    for (const CheckItem& line : checks.items()) {
        EXPECT_EQ(line.state, State::kGood) << line.title.toStdString() << ": " << line.sentence.toStdString();
    }
}

TEST_F(ConnectionChecksTest, ADisconnectedInstrumentLeavesNoGreenLamp) {
    connectInstrument();
    instrument.disconnectInstrument();
    pass(1s);
    for (const CheckItem& line : checks.items()) {
        EXPECT_EQ(line.state, State::kIdle) << line.title.toStdString();
    }
}

TEST_F(ConnectionChecksTest, AnInstrumentThatAnsweredIsNotAccusedOfItsSpeedWhenItsUnitsDoNotCome) {
    auto wires = wiring();
    wires.make_link = [this](const SerialChoice&) {
        auto link = makeLink();
        instrument_end->on_received = [this](std::string_view bytes) {
            if (!bytes.starts_with("RG,23")) {
                station.receive(bytes);
            }
        };
        return link;
    };
    InstrumentDesk desk(gate, wires);
    ConnectionChecks list(desk);
    QSignalSpy failed(&desk, &InstrumentDesk::connectFailed);
    SerialChoice choice;
    choice.path = QStringLiteral("memory");
    desk.connectSerial(choice);
    ASSERT_TRUE(until([&] { return !failed.empty(); }));
    EXPECT_EQ(list.items()[ConnectionChecks::kGrammar].state, State::kGood)
        << list.items()[ConnectionChecks::kGrammar].sentence.toStdString();
    EXPECT_EQ(list.items()[ConnectionChecks::kUnits].state, State::kFailed);
    EXPECT_EQ(list.items()[ConnectionChecks::kUnits].sentence, failed.first().at(0).value<core::Error>().sentence());
}

/// The same over the simulated base on its bus.
class BusChecksTest : public FieldTest {
protected:
    BusChecksTest() { true_pointing->place({.ha = Angle::fromGon(177.56115), .va = Angle::fromGon(96.16838)}); }
    void TearDown() override {
        desk.disconnectInstrument();
        FieldTest::TearDown();
    }
    InstrumentWiring busWiring() {
        auto wires = wiring();
        wires.make_link = [this](const SerialChoice&) {
            auto pair = transport::makeMemoryPair(clock);
            base_end = std::move(pair.second);
            (void)base_end->open();
            base_end->on_received = [this](std::string_view bytes) { base.receive(bytes); };
            base.send = [this](std::string_view bytes) { base_end->write(bytes); };
            return std::move(pair.first);
        };
        return wires;
    }
    void connectOn(instrument::LineDialect dialect) {
        SerialChoice choice;
        choice.path = QStringLiteral("bus");
        choice.dialect = dialect;
        desk.connectSerial(choice);
    }
    void connectBus() {
        connectOn(instrument::LineDialect::kBus);
        ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnected; }));
        pass(2s);
    }
    [[nodiscard]] const CheckItem& item(ConnectionChecks::Check check) const { return checks.items().at(check); }

    simulator::BusStation base{{}, true_pointing, clock};
    std::unique_ptr<transport::MemoryLink> base_end;
    InstrumentDesk desk{gate, busWiring()};
    ConnectionChecks checks{desk};
    MemoryPresenter memory{desk, planned, messages};
};

TEST_F(BusChecksTest, TheBusHasItemsOfItsOwn) {
    connectBus();
    QStringList titles;
    for (const CheckItem& line : checks.items()) {
        if (!line.title.isEmpty()) {
            titles << line.title;
            EXPECT_EQ(line.state, State::kGood) << line.title.toStdString();
        }
        EXPECT_FALSE(line.sentence.contains(QStringLiteral("Request"))) << "there is no such setting on the bus";
    }
    EXPECT_EQ(titles, (QStringList{QStringLiteral("Port"), QStringLiteral("Stream"), QStringLiteral("Angles")}));
}

TEST_F(BusChecksTest, ASilentBaseIsToldInTheListAndInTheState) {
    connectBus();
    ASSERT_TRUE(base.injectFault(QStringLiteral("power_off=20")).has_value());
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kReconnecting; }, 5s));
    EXPECT_EQ(item(ConnectionChecks::kPort).state, State::kFailed);
    EXPECT_EQ(item(ConnectionChecks::kStream).state, State::kIdle);
    EXPECT_EQ(item(ConnectionChecks::kAngles).state, State::kIdle);
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kConnected; }));
    EXPECT_EQ(item(ConnectionChecks::kStream).state, State::kGood);
}

TEST_F(BusChecksTest, ABaseWithoutAStreamFailsInTheItemOfTheStream) {
    ASSERT_TRUE(base.injectFault(QStringLiteral("power_off=60")).has_value());
    QSignalSpy failed(&desk, &InstrumentDesk::connectFailed);
    connectOn(instrument::LineDialect::kBus);
    ASSERT_TRUE(until([&] { return !failed.empty(); }));
    EXPECT_EQ(item(ConnectionChecks::kPort).state, State::kGood);
    EXPECT_EQ(item(ConnectionChecks::kStream).state, State::kFailed);
}

TEST_F(BusChecksTest, ABusTakenForTheExternalInterfaceIsNamed) {
    QSignalSpy failed(&desk, &InstrumentDesk::connectFailed);
    connectOn(instrument::LineDialect::kExternal);
    ASSERT_TRUE(until([&] { return !failed.empty(); }));
    EXPECT_TRUE(item(ConnectionChecks::kGrammar).sentence.contains(QStringLiteral("bus under the panel")))
        << item(ConnectionChecks::kGrammar).sentence.toStdString();
}

TEST_F(BusChecksTest, TheMemoryIsNotAskedForAndSaysWhereItIsReached) {
    connectBus();
    EXPECT_TRUE(memory.isConnected());
    EXPECT_FALSE(memory.isReachable());
    EXPECT_TRUE(memory.roomText().contains(QStringLiteral("external interface only"))) << memory.roomText().toStdString();
    memory.refresh();
    pass(1s);
    EXPECT_FALSE(memory.transfer().busy);
    EXPECT_TRUE(messages.bars().empty());
}

TEST_F(BusChecksTest, NothingIsAskedOfTheInstrumentsCare) {
    InstrumentHealth health(desk, preferences, messages, clock);
    connectBus();
    health.refresh();
    health.switchCompensator(true);
    health.calibrateCompensator();
    pass(2s);
    EXPECT_FALSE(health.canAsk());
    EXPECT_FALSE(health.isCalibrating());
    EXPECT_TRUE(messages.bars().empty());
    EXPECT_TRUE(health.compensator().details.contains(QStringLiteral("bus")));
}

}  // namespace
}  // namespace pmts::app
