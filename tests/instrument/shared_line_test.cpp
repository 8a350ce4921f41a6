#include "pmts/instrument/instrument_connection.hpp"
#include "scripted_instrument.hpp"

namespace pmts::instrument {
namespace {

using scheduler::ControlMode;
using scheduler::LineOwner;
using scheduler::Outcome;

/// An instrument on one port and a panel on the other, both scripted.
class SharedLineTest : public testing::Test {
protected:
    static ConnectionSettings settings(PathSwitch path_switch = {}) {
        ConnectionSettings values;
        values.path_switch = path_switch;
        return values;
    }
    explicit SharedLineTest(ConnectionSettings values = settings())
        : connection([this](const QString&) { return makeInstrument(); }, clock, gate, std::move(values)) {
        connection.on_panel_turn = [this](const scheduler::TransactionRecord& record) { turns.push_back(record); };
        connection.on_state = [this](ConnectionState, const QString& sentence) { sentences.push_back(sentence); };
    }

    std::unique_ptr<transport::ByteLink> makeInstrument() {
        auto made = std::make_unique<test::ScriptedLink>(clock);
        made->close();
        link = made.get();
        station = std::make_unique<ScriptedInstrument>(*link, clock);
        return made;
    }
    void plugPanel() {
        connection.usePanel([this] {
            auto made = std::make_unique<test::ScriptedLink>(clock);
            made->close();
            made->unavailable = !panel_there;
            panel = made.get();
            return made;
        });
    }
    void connect() {
        const auto who = test::runToEnd(connection.connectTo(QStringLiteral("A")), clock, 30s);
        ASSERT_TRUE(who.has_value() && who->has_value());
        clock.advance(1s);
    }
    /// What the panel has heard of its question.
    std::string panelAsks(const std::string& command) {
        panel->written.clear();
        panel->say(command);
        clock.advance(200ms);
        std::string heard;
        for (const auto& part : panel->written) {
            heard += part;
        }
        return heard;
    }
    [[nodiscard]] long sent(const std::string& command) const {
        return std::count(link->written.begin(), link->written.end(), command + "\r");
    }

    core::VirtualClock clock;
    core::VideoGate gate;
    test::ScriptedLink* link = nullptr;
    test::ScriptedLink* panel = nullptr;
    bool panel_there = true;
    std::unique_ptr<ScriptedInstrument> station;
    std::vector<scheduler::TransactionRecord> turns;
    QStringList sentences;
    InstrumentConnection connection;
};

TEST_F(SharedLineTest, WithOnePortThereIsNoPanel) {
    connect();

    EXPECT_EQ(connection.control().panel, PanelPortState::kNone);
    EXPECT_EQ(connection.control().mode, ControlMode::kShared);
    EXPECT_TRUE(link->control_lines.empty() || link->control_lines.back() == transport::ControlLines{});
}

TEST_F(SharedLineTest, ThePanelReadsWhilePmtsPolls) {
    plugPanel();
    connect();

    EXPECT_EQ(panelAsks("RG,55\r"), "55=620123\r\n>");
    EXPECT_TRUE(connection.poller().isRunning());
    EXPECT_EQ(connection.line().counts().unsolicited, 0U);
    EXPECT_EQ(connection.control().counts.panel_turns, 1U);
}

TEST_F(SharedLineTest, ThePanelReadsBetweenTheStepsOfATurn) {
    plugPanel();
    connect();
    for (int i = 1; i < 10; ++i) {
        panel->say("RG,55\r", i * 300ms);
    }
    const geometry::Pointing target{.ha = Angle::fromGon(20), .va = Angle::fromGon(95)};
    const auto arrived = test::runToEnd(connection.station().turnTo(target, Angle::fromCc(5), {}), clock, 60s);

    ASSERT_TRUE(arrived.has_value() && arrived->has_value());
    clock.advance(5s);
    EXPECT_EQ(turns.size(), 9U);
    EXPECT_TRUE(std::ranges::all_of(turns, [](const auto& turn) { return turn.received == "55=620123\r\n>"; }));
}

TEST_F(SharedLineTest, InPanelModePmtsIsSilentStaysConnectedAndThePanelGoesThrough) {
    plugPanel();
    connect();
    connection.setControlMode(ControlMode::kPanel);
    clock.advance(1s);
    link->written.clear();
    clock.advance(60s);

    EXPECT_TRUE(link->written.empty());
    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
    EXPECT_EQ(panelAsks("RG,7\r"), "7=10.0000\r\n>");
    EXPECT_EQ(turns.back().received, "7=10.0000\r\n>");
    EXPECT_EQ(connection.control().owner, LineOwner::kPanel);
}

TEST_F(SharedLineTest, InPanelModeARequestFailsAtOnceWithASentence) {
    connect();
    connection.setControlMode(ControlMode::kPanel);
    clock.advance(1s);
    const auto measured = test::runToEnd(connection.station().measureDistance({}), clock, 1s);

    ASSERT_TRUE(measured.has_value());
    EXPECT_THAT(*measured, test::FailedWith(ErrorKind::kRefused));
    EXPECT_TRUE(measured->error().happened.contains(QStringLiteral("panel has control")));
}

TEST_F(SharedLineTest, AMotionThatRunsIsFinishedBeforeThePanelTakesOver) {
    plugPanel();
    connect();
    const geometry::Pointing target{.ha = Angle::fromGon(200), .va = Angle::fromGon(95)};
    const auto timer = clock.callAfter(1s, [this] { connection.setControlMode(ControlMode::kPanel); });
    const auto arrived = test::runToEnd(connection.station().turnTo(target, Angle::fromCc(5), {}), clock, 60s);

    ASSERT_TRUE(arrived.has_value());
    EXPECT_THAT(*arrived, test::FailedWith(ErrorKind::kRefused));  // arrival could not be verified
    EXPECT_DOUBLE_EQ(station->ha, 200.0);                          // but the motion was not broken into
    clock.advance(1s);
    EXPECT_EQ(connection.control().mode, ControlMode::kPanel);
}

TEST_F(SharedLineTest, WhenControlIsBackTheInstrumentIsAskedAgainBeforeAnythingIsRead) {
    plugPanel();
    connect();
    connection.setControlMode(ControlMode::kPanel);
    clock.advance(1s);
    link->written.clear();
    connection.setControlMode(ControlMode::kShared);
    clock.advance(3s);

    ASSERT_FALSE(link->written.empty());
    EXPECT_EQ(link->written.front(), "RG,79\r");
    EXPECT_GE(sent("RG,23"), 1);
    EXPECT_TRUE(connection.poller().isRunning());
}

TEST_F(SharedLineTest, ControlTakenBackBeforeThePanelHadItLeavesPmtsWorking) {
    connect();
    const geometry::Pointing target{.ha = Angle::fromGon(200), .va = Angle::fromGon(95)};
    const auto give = clock.callAfter(1s, [this] { connection.setControlMode(ControlMode::kPanel); });
    const auto back = clock.callAfter(1100ms, [this] { connection.setControlMode(ControlMode::kShared); });
    const auto arrived = test::runToEnd(connection.station().turnTo(target, Angle::fromCc(5), {}), clock, 60s);

    ASSERT_TRUE(arrived.has_value() && arrived->has_value());
    clock.advance(2s);
    EXPECT_TRUE(connection.poller().isRunning());
}

TEST_F(SharedLineTest, UnitsThatThePanelChangesAreReadBeforeTheNextAngleIsBelieved) {
    plugPanel();
    connect();
    std::vector<geometry::Pointing> seen;
    connection.station().on_pointing = [&](const geometry::Pointing& at, core::Duration) { seen.push_back(at); };
    station->ha = 9.0;  // 9 degrees are 10 gon, as before
    station->va = 90.0;
    EXPECT_EQ(panelAsks("WG,23=1112\r"), ">");
    clock.advance(5s);

    EXPECT_GE(sent("RG,23"), 1);
    ASSERT_FALSE(seen.empty());
    for (const auto& at : seen) {
        EXPECT_THAT(at.ha, test::IsNearAngle(Angle::fromGon(10), Angle::fromCc(1)));
    }
}

TEST_F(SharedLineTest, ABlockEndThatThePanelChangesIsFollowed) {
    plugPanel();
    connect();
    link->respond = [this](const std::string& command) {
        const auto usual = station->answer(command);
        station->end = command.starts_with("WG,79=") ? "#" : station->end;  // for this very answer
        return command.starts_with("WG,79=") ? std::optional<std::string>("#") : usual;
    };
    panel->say("WG,79=35\r");
    clock.advance(5s);

    EXPECT_EQ(connection.line().endMark(), '#');
    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
    EXPECT_EQ(panelAsks("RG,55\r"), "55=620123\r\n#");
}

TEST_F(SharedLineTest, ConnectingWaitsWhileThePanelHasControl) {
    plugPanel();
    connection.setControlMode(ControlMode::kPanel);
    std::optional<core::Result<Identity>> who;
    const auto connecting = [](auto task, auto& outcome) -> core::Task<void> { outcome = co_await task; }(
                                                               connection.connectTo(QStringLiteral("A")), who);
    clock.advance(30s);
    EXPECT_FALSE(who.has_value());
    EXPECT_TRUE(link->written.empty());
    EXPECT_TRUE(sentences.last().contains(QStringLiteral("panel has control")));
    EXPECT_EQ(panelAsks("RG,7\r"), "7=10.0000\r\n>");
    connection.setControlMode(ControlMode::kShared);
    clock.advance(5s);

    ASSERT_TRUE(who.has_value() && who->has_value());
    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
}

TEST_F(SharedLineTest, DisconnectEndsTheWaitForControl) {
    connection.setControlMode(ControlMode::kPanel);
    std::optional<core::Result<Identity>> who;
    const auto connecting = [](auto task, auto& outcome) -> core::Task<void> { outcome = co_await task; }(
                                                               connection.connectTo(QStringLiteral("A")), who);
    clock.advance(1s);
    connection.disconnect();
    clock.advance(1s);

    ASSERT_TRUE(who.has_value());
    EXPECT_THAT(*who, test::FailedWith(ErrorKind::kCancelled));
}

TEST_F(SharedLineTest, InComputerModeThePanelIsSwallowedAndLogged) {
    plugPanel();
    connect();
    connection.setControlMode(ControlMode::kComputer);

    EXPECT_EQ(panelAsks("WG,5=13\r"), "");
    EXPECT_EQ(sent("WG,5=13"), 0);
    ASSERT_EQ(turns.size(), 1U);
    EXPECT_EQ(turns[0].outcome, Outcome::kSwallowed);
}

TEST_F(SharedLineTest, APanelPulledInMidTransactionIsSaidAndComesBack) {
    plugPanel();
    connect();
    panel_there = false;
    panel->say("RG,55\r");
    clock.advance(5ms);
    panel->unplug();
    clock.advance(3s);
    EXPECT_EQ(connection.control().panel, PanelPortState::kMissing);
    EXPECT_FALSE(connection.control().panel_sentence.isEmpty());
    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
    panel_there = true;
    clock.advance(6s);

    EXPECT_EQ(connection.control().panel, PanelPortState::kOpen);
    EXPECT_EQ(panelAsks("RG,55\r"), "55=620123\r\n>");
}

TEST_F(SharedLineTest, ThePanelsPortIsOpenOnlyWhileTheConnectionIsUsed) {
    plugPanel();
    EXPECT_EQ(connection.control().panel, PanelPortState::kNone);
    connect();
    EXPECT_EQ(connection.control().panel, PanelPortState::kOpen);
    connection.disconnect();

    EXPECT_EQ(connection.control().panel, PanelPortState::kNone);
}

TEST_F(SharedLineTest, AfterALostInstrumentThePanelGoesOnWithIt) {
    plugPanel();
    connect();
    link->unplug();
    EXPECT_EQ(panelAsks("RG,55\r"), "");
    clock.advance(5s);

    EXPECT_EQ(connection.state(), ConnectionState::kConnected);
    EXPECT_EQ(panelAsks("RG,55\r"), "55=620123\r\n>");
}

TEST_F(SharedLineTest, TheOwnerIsToldWithItsTime) {
    std::vector<LineOwner> owners;
    connection.on_control = [&](const ControlStatus& status) {
        EXPECT_EQ(status.owner_since, clock.now());
        owners.push_back(status.owner);
    };
    (void)test::runToEnd(connection.connectTo(QStringLiteral("A")), clock, 100ms);

    EXPECT_TRUE(std::ranges::count(owners, LineOwner::kComputer) > 0);
}

class SwitchBoxTest : public SharedLineTest {
protected:
    SwitchBoxTest() : SharedLineTest(settings({.dtr = LineInModes{}, .rts = std::nullopt, .inverted = true})) {}
};

TEST_F(SwitchBoxTest, DtrSwitchesThePathWithTheMode) {
    connect();
    EXPECT_EQ(link->control_lines.back(), (transport::ControlLines{.dtr = true, .rts = std::nullopt}));
    connection.setControlMode(ControlMode::kPanel);
    clock.advance(1s);
    EXPECT_EQ(link->control_lines.back(), (transport::ControlLines{.dtr = false, .rts = std::nullopt}));
    connection.setControlMode(ControlMode::kComputer);
    clock.advance(1s);

    EXPECT_EQ(link->control_lines.back(), (transport::ControlLines{.dtr = true, .rts = std::nullopt}));
}

TEST_F(SwitchBoxTest, ThePathIsNotSwitchedInMidTransaction) {
    connect();
    const geometry::Pointing target{.ha = Angle::fromGon(200), .va = Angle::fromGon(95)};
    const auto switches = link->control_lines.size();
    const auto give = clock.callAfter(1s, [this] { connection.setControlMode(ControlMode::kPanel); });
    auto turning = connection.station().turnTo(target, Angle::fromCc(5), {});
    clock.advance(1500ms);
    EXPECT_EQ(link->control_lines.size(), switches);
    clock.advance(5s);

    EXPECT_EQ(link->control_lines.back().dtr, false);
}

}  // namespace
}  // namespace pmts::instrument
