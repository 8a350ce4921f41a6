#include "pmts/app/line/control_presenter.hpp"

#include "field_fixture.hpp"

namespace pmts::app {
namespace {

using instrument::LineInModes;
using instrument::PanelPortState;
using scheduler::ControlMode;
using scheduler::LineOwner;

/// The desk with a second port, at whose other end the test is the panel.
class ControlTest : public FieldTest {
protected:
    ControlTest() {
        QObject::connect(&shared, &InstrumentDesk::transactionFinished, [this](const scheduler::TransactionRecord& record) {
            if (record.master == scheduler::Master::kPanel) {
                turns.push_back(record);
            }
        });
    }
    void TearDown() override {
        shared.disconnectInstrument();
        FieldTest::TearDown();
    }

    InstrumentWiring sharedWiring() {
        auto wires = wiring();
        wires.make_link = [this](const SerialChoice& choice) { return choice.path == panelPort().path ? makePanel() : makeLink(); };
        return wires;
    }
    std::unique_ptr<transport::ByteLink> makePanel() {
        auto pair = transport::makeMemoryPair(clock);
        if (!panel_plugged) {
            pair.first->unplug();
            return std::move(pair.first);
        }
        panel_end = std::move(pair.second);
        (void)panel_end->open();
        panel_end->on_received = [this](std::string_view bytes) { panel_heard += bytes; };
        return std::move(pair.first);
    }
    static SerialChoice panelPort() {
        SerialChoice port;
        port.path = QStringLiteral("panel");
        return port;
    }
    void connectShared() {
        SerialChoice choice;
        choice.path = QStringLiteral("memory");
        shared.connectSerial(choice);
        ASSERT_TRUE(until([this] { return shared.connectionState() == ConnectionState::kConnected; }));
        pass(1s);
    }
    std::string panelAsks(const std::string& command) {
        panel_heard.clear();
        panel_end->write(command);
        pass(2s);
        return panel_heard;
    }

    InstrumentDesk shared{gate, sharedWiring()};
    std::unique_ptr<transport::MemoryLink> panel_end;
    bool panel_plugged = true;
    std::string panel_heard;
    std::vector<scheduler::TransactionRecord> turns;
    std::vector<LineOwner> owners;
    std::optional<core::Error> refused;
    ControlPresenter control{shared, preferences, messages, clock};
};

TEST_F(ControlTest, WithOnePortEverythingIsAsBefore) {
    connectShared();

    EXPECT_EQ(control.mode(), ControlMode::kShared);
    EXPECT_EQ(control.panelPort().state, DeviceState::kIdle);
    EXPECT_TRUE(messages.bars().empty());
}

TEST_F(ControlTest, APanelOnTheSecondPortReadsAndIsLogged) {
    control.usePanel(panelPort());
    connectShared();

    EXPECT_EQ(control.panelPort().state, DeviceState::kGood);
    EXPECT_EQ(panelAsks("RG,55\r"), "55=620123\r\n>");
    ASSERT_EQ(turns.size(), 1U);
    EXPECT_EQ(turns[0].sent, "RG,55\r");
    EXPECT_EQ(control.counters().at(1).value, QStringLiteral("1"));
}

TEST_F(ControlTest, APanelMayBeAddedWhileTheInstrumentIsConnected) {
    connectShared();
    control.usePanel(panelPort());
    pass(1s);
    EXPECT_EQ(panelAsks("RG,55\r"), "55=620123\r\n>");
    control.removePanel();
    pass(1s);

    EXPECT_EQ(control.panelPort().text, QStringLiteral("No panel"));
    EXPECT_EQ(shared.connectionState(), ConnectionState::kConnected);
}

TEST_F(ControlTest, InPanelModePmtsIsSilentAndARequestSaysWhy) {
    control.usePanel(panelPort());
    connectShared();
    control.setMode(ControlMode::kPanel);
    pass(2s);
    sent.clear();
    pass(30s);
    EXPECT_TRUE(sent.empty());
    EXPECT_EQ(control.owner(), LineOwner::kPanel);

    QObject::connect(&shared, &InstrumentDesk::requestFailed, [this](Ticket, const core::Error& error) { refused = error; });
    shared.measureDistance();
    ASSERT_TRUE(until([this] { return refused.has_value(); }, 1s));
    EXPECT_EQ(refused->kind, core::ErrorKind::kRefused);
    EXPECT_TRUE(refused->happened.contains(QStringLiteral("panel has control")));
    EXPECT_EQ(panelAsks("RG,55\r"), "55=620123\r\n>");
}

TEST_F(ControlTest, ControlComesBackAndReadingsGoOn) {
    connectShared();
    control.setMode(ControlMode::kPanel);
    pass(2s);
    control.setMode(ControlMode::kShared);
    pass(5s);
    const auto before = shared.track().newest()->at;
    pass(2s);

    EXPECT_EQ(control.mode(), ControlMode::kShared);
    EXPECT_GT(shared.track().newest()->at, before);
}

TEST_F(ControlTest, InComputerModeTheLogShowsWhatWasSwallowed) {
    control.usePanel(panelPort());
    connectShared();
    control.setMode(ControlMode::kComputer);
    pass(1s);

    EXPECT_EQ(panelAsks("WG,5=13\r"), "");
    ASSERT_EQ(turns.size(), 1U);
    EXPECT_EQ(turns[0].outcome, scheduler::Outcome::kSwallowed);
    EXPECT_EQ(control.counters().at(3).value, QStringLiteral("1"));
}

TEST_F(ControlTest, AChangeWaitsForTheRunningMotionAndSaysSo) {
    connectShared();
    shared.turnTo({.ha = Angle::fromGon(120), .va = Angle::fromGon(95)}, Angle::fromCc(5));
    pass(1s);
    control.setMode(ControlMode::kPanel);
    pass(100ms);
    EXPECT_TRUE(control.isChanging());
    EXPECT_EQ(control.mode(), ControlMode::kShared);
    EXPECT_TRUE(control.ownerLamp().details.contains(QStringLiteral("Panel")));
    pass(20s);

    EXPECT_EQ(control.mode(), ControlMode::kPanel);
    EXPECT_NEAR(true_pointing->at(clock.now()).ha.gon(), 120.0, 0.001);
}

TEST_F(ControlTest, AMissingPanelPortIsSaidAndSolvedWhenItIsBack) {
    panel_plugged = false;
    control.usePanel(panelPort());
    connectShared();
    EXPECT_EQ(control.panelPort().state, DeviceState::kFailed);
    EXPECT_TRUE(newestBar(messages).contains(QStringLiteral("panel's port is missing")));
    panel_plugged = true;
    pass(10s);

    EXPECT_EQ(control.panelPort().state, DeviceState::kGood);
    EXPECT_TRUE(messages.bars().empty());
    EXPECT_EQ(shared.connectionState(), ConnectionState::kConnected);
}

TEST_F(ControlTest, TheInstrumentsOwnPortIsNoPanelPort) {
    auto next = preferences.settings();
    next.last_device = LastDevice::kSerial;
    next.serial.path = QStringLiteral("panel");
    preferences.set(next);
    control.usePanel(panelPort());

    EXPECT_FALSE(control.settings().panel.has_value());
    EXPECT_TRUE(newestBar(messages).contains(QStringLiteral("instrument's port")));
}

TEST_F(ControlTest, ALineWithoutDtrSaysThatTheSwitchIsNotDriven) {
    connectShared();
    control.setPathSwitch({.dtr = LineInModes{}, .rts = std::nullopt, .inverted = false});
    pass(100ms);

    EXPECT_TRUE(newestBar(messages).contains(QStringLiteral("switch is not driven")));
}

TEST_F(ControlTest, TheLampFollowsTheOwner) {
    QObject::connect(&control, &ControlPresenter::ownerChanged, [this] { owners.push_back(control.owner()); });
    control.usePanel(panelPort());
    connectShared();
    (void)panelAsks("RG,55\r");

    EXPECT_TRUE(std::ranges::count(owners, LineOwner::kComputer) > 0);
    EXPECT_EQ(std::ranges::count(owners, LineOwner::kPanel), 1);
}

TEST_F(ControlTest, TheShownOwnerDoesNotFlickerWithPmtsOwnPolls) {
    int changes = 0;
    connectShared();
    QObject::connect(&control, &ControlPresenter::shownOwnerChanged, [&changes] { ++changes; });
    pass(10s);

    EXPECT_EQ(changes, 0);
    EXPECT_EQ(control.shownOwner(), LineOwner::kComputer);
    EXPECT_EQ(control.barItem().text, QStringLiteral("PC in control"));
}

TEST_F(ControlTest, APanelsTransactionShowsForHalfASecond) {
    control.usePanel(panelPort());
    connectShared();
    EXPECT_EQ(control.barItem().text, QStringLiteral("Shared: PC"));
    panel_end->write("RG,55\r");
    pass(300ms);
    EXPECT_EQ(control.barItem().text, QStringLiteral("Shared: panel"));
    pass(1s);

    EXPECT_EQ(control.barItem().text, QStringLiteral("Shared: PC"));
    EXPECT_EQ(control.ownerLamp().text, QStringLiteral("PMTS has the line")) << "no time where they take turns";
}

TEST_F(ControlTest, ARefusalInPanelModeOffersToTakeControlBack) {
    connectShared();
    control.setMode(ControlMode::kComputer);
    control.setMode(ControlMode::kPanel);
    pass(1s);
    EXPECT_EQ(control.barItem().text, QStringLiteral("Panel in control"));
    EXPECT_TRUE(control.ownerLamp().text.startsWith(QStringLiteral("The panel has the line, for ")));
    QObject::connect(&shared, &InstrumentDesk::requestFailed,
                     [this](Ticket, const core::Error& error) { messages.report(error, MessageAction::kRetryRecord); });
    shared.measureDistance();
    shared.turnTo({.ha = Angle::fromGon(10), .va = Angle::fromGon(100)}, Angle::fromCc(5));
    pass(1s);
    ASSERT_EQ(messages.bars().size(), 1U) << "one bar for all that was refused";
    EXPECT_EQ(messages.bars()[0].action, MessageAction::kTakeControl);
    control.takeControl();
    pass(1s);

    EXPECT_EQ(control.mode(), ControlMode::kComputer) << "as it was before the panel";
    EXPECT_TRUE(messages.bars().empty());
}

TEST_F(ControlTest, AStartInPanelModeSaysWhatItWaitsFor) {
    control.setMode(ControlMode::kPanel);
    SerialChoice choice;
    choice.path = QStringLiteral("memory");
    shared.connectSerial(choice);
    pass(1s);
    EXPECT_EQ(shared.connectionState(), ConnectionState::kConnecting);
    ASSERT_EQ(messages.bars().size(), 1U);
    EXPECT_EQ(messages.bars()[0].action, MessageAction::kTakeControl);
    control.takeControl();
    ASSERT_TRUE(until([this] { return shared.connectionState() == ConnectionState::kConnected; }));
    EXPECT_TRUE(messages.bars().empty());
}

TEST_F(ControlTest, TheSimulatorsPanelIsNotRemembered) {
    control.usePanelForNow(panelPort());
    connectShared();
    EXPECT_EQ(control.panelPort().state, DeviceState::kGood);
    EXPECT_FALSE(preferences.settings().control.panel.has_value());
    control.setMode(ControlMode::kComputer);
    EXPECT_FALSE(preferences.settings().control.panel.has_value());
    control.removePanel();
    pass(1s);

    EXPECT_EQ(control.panelPort().text, QStringLiteral("No panel"));
}

TEST_F(ControlTest, TheOpenPortOfTheInstrumentIsNoPanelPort) {
    connectShared();
    SerialChoice same;
    same.path = QStringLiteral("memory");
    control.usePanel(same);

    EXPECT_FALSE(control.settings().panel.has_value());
    EXPECT_TRUE(newestBar(messages).contains(QStringLiteral("instrument's port")));
}

TEST(ControlSettingsTest, WhatIsChosenHoldsForTheNextStart) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("settings.ini"));
    Settings written;
    written.control.mode = ControlMode::kComputer;
    written.control.panel = SerialChoice{};
    written.control.panel->path = QStringLiteral("/dev/ttyUSB1");
    written.control.panel->adapter.last_path = written.control.panel->path;
    written.control.panel->baud = 4800;
    written.control.path_switch = {.dtr = LineInModes{.shared = true, .computer = false, .panel = false},
                                   .rts = std::nullopt, .inverted = true};
    ASSERT_TRUE(written.save(path).has_value());
    EXPECT_EQ(Settings::load(path).control, written.control);

    written.control = {};
    ASSERT_TRUE(written.save(path).has_value());
    EXPECT_EQ(Settings::load(path).control, ControlSettings());
}

}  // namespace
}  // namespace pmts::app
