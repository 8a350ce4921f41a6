#include "field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

const QString kFirst = QStringLiteral("/dev/ttyUSB0");
const QString kSecond = QStringLiteral("/dev/ttyUSB1");

/// Two USB adapters whose names change: the instrument's, and one with another device behind it.
class AdapterPortTest : public FieldTest {
protected:
    void TearDown() override {
        desk.disconnectInstrument();
        FieldTest::TearDown();
    }
    static transport::PortInfo adapter(const char* serial, const QString& path) {
        return {.path = path, .description = {}, .manufacturer = {}, .serial_number = QString::fromLatin1(serial),
                .usb_vendor = 0x0403, .usb_product = 0x6001};
    }
    static transport::PortInfo ours(const QString& path) { return adapter("OURS", path); }
    static transport::PortInfo another(const QString& path) { return adapter("ANOTHER", path); }
    static SerialChoice chosen() {
        SerialChoice choice;
        choice.path = kFirst;
        choice.adapter = ours(kFirst).identity();
        return choice;
    }

    std::unique_ptr<transport::ByteLink> linkAt(const QString& path) {
        const auto port = std::ranges::find(present, path, &transport::PortInfo::path);
        if (port != present.end() && port->serial_number == QLatin1String("OURS")) {
            return makeLink();
        }
        auto pair = transport::makeMemoryPair(clock);
        if (port == present.end()) {
            pair.first->unplug();
            return std::move(pair.first);
        }
        others_end = std::move(pair.second);
        (void)others_end->open();
        others_end->on_received = [this](std::string_view bytes) { heard_by_another += bytes; };
        return std::move(pair.first);
    }
    InstrumentWiring usbWiring() {
        auto wires = wiring();
        wires.make_link = [this](const SerialChoice& choice) { return linkAt(choice.path); };
        wires.list_ports = [this] { return present; };
        return wires;
    }
    [[nodiscard]] bool isConnected() const { return desk.connectionState() == ConnectionState::kConnected; }
    void connectThere() {
        desk.connectSerial(chosen());
        ASSERT_TRUE(until([this] { return isConnected(); }));
    }

    std::vector<transport::PortInfo> present{ours(kFirst)};
    std::unique_ptr<transport::MemoryLink> others_end;
    std::string heard_by_another;
    InstrumentDesk desk{gate, usbWiring()};
};

TEST_F(AdapterPortTest, AnAdapterThatMovedSinceTheLastStartIsUsedWhereItIsNow) {
    present = {another(kFirst), ours(kSecond)};
    connectThere();
    EXPECT_EQ(desk.choice().path, kSecond);
    EXPECT_EQ(heard_by_another, "");
}

TEST_F(AdapterPortTest, AnAdapterThatComesBackUnderAnotherNameIsConnectedAgain) {
    connectThere();
    unplug();
    present.clear();
    ASSERT_TRUE(until([this] { return desk.connectionState() == ConnectionState::kReconnecting; }));
    pass(3s);
    present = {ours(kSecond)};
    plugIn();
    EXPECT_TRUE(until([this] { return isConnected(); }));
}

TEST_F(AdapterPortTest, WhereTwoAdaptersSwapTheirNamesNothingIsSentToTheOther) {
    present = {ours(kFirst), another(kSecond)};
    connectThere();
    unplug();
    present = {another(kFirst), ours(kSecond)};
    plugIn();
    answers = false;  // for a while, so that every name that might be tried is
    pass(20s);
    EXPECT_EQ(desk.connectionState(), ConnectionState::kReconnecting);
    answers = true;
    EXPECT_TRUE(until([this] { return isConnected(); }));
    EXPECT_EQ(heard_by_another, "");
}

TEST_F(AdapterPortTest, AMissingAdapterIsSaidAndWhoHasItsNameIsLeftAlone) {
    present = {another(kFirst)};
    QSignalSpy failed(&desk, &InstrumentDesk::connectFailed);
    desk.connectSerial(chosen());
    ASSERT_TRUE(until([&] { return !failed.empty(); }));
    const auto error = failed.first().at(0).value<core::Error>();
    EXPECT_EQ(error.kind, core::ErrorKind::kPortUnavailable);
    EXPECT_TRUE(error.happened.contains(QStringLiteral("not plugged in"))) << error.happened.toStdString();
    EXPECT_EQ(heard_by_another, "");
}

TEST_F(AdapterPortTest, TheFormShowsTheLastAdapterWhereItIsNow) {
    SimulationDesk simulation;
    ConnectionPresenter connection{desk, simulation, live, gate, preferences, messages, [] {
                                       return std::vector<video::SourceAddress>();
                                   }};
    connection.setPortList([this] { return present; });
    Settings settings = preferences.settings();
    settings.serial = chosen();
    preferences.set(settings);
    present = {another(kFirst), ours(kSecond)};
    connection.refreshPorts();
    EXPECT_EQ(connection.serialChoice().path, kSecond);
    EXPECT_EQ(connection.ports().front().path, kSecond);
    EXPECT_FALSE(connection.ports().back().used_last) << "it only has the name";
}

}  // namespace
}  // namespace pmts::app
