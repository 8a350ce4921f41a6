#include "arbiter_fixture.hpp"

namespace pmts::scheduler {
namespace {

const core::Error kPanelHasIt{.kind = ErrorKind::kRefused,
                              .happened = QStringLiteral("The panel has control."),
                              .remedy = {},
                              .info_code = std::nullopt,
                              .detail = {}};

class ControlModeTest : public ArbiterTest {
protected:
    ControlModeTest() {
        arbiter.on_mode = [this](ControlMode, ControlMode mode) { modes.push_back(mode); };
    }
    std::vector<ControlMode> modes;
};

TEST_F(ControlModeTest, InComputerModeThePanelIsSwallowedAndLogged) {
    arbiter.setMode(ControlMode::kComputer);
    panelSays("RG,7\r");
    clock.advance(1s);

    EXPECT_TRUE(instrument.written.empty());
    ASSERT_EQ(turns.size(), 1U);
    EXPECT_EQ(turns[0].sent, "RG,7\r");
    EXPECT_EQ(turns[0].outcome, Outcome::kSwallowed);
    EXPECT_EQ(arbiter.counts().swallowed, 1U);
}

TEST_F(ControlModeTest, InPanelModeTheLineIsAWire) {
    arbiter.setMode(ControlMode::kPanel);
    panelSays("RG");
    EXPECT_EQ(instrumentHeard(), "RG");
    panelSays(",7\r");
    instrumentSays("7=10.2345\r\n>");

    EXPECT_EQ(instrumentHeard(), "RG,7\r");
    EXPECT_EQ(panelHeard(), "7=10.2345\r\n>");
    EXPECT_EQ(turns.at(0).sent, "RG,7\r");  // logged all the same
    EXPECT_EQ(turns.at(0).received, "7=10.2345\r\n>");
}

TEST_F(ControlModeTest, InPanelModePmtsSendsNothingAndSaysWhy) {
    line.bar(kPanelHasIt);
    arbiter.setMode(ControlMode::kPanel);
    const auto reading = ask(read(7));
    core::deliverQueuedEvents();

    ASSERT_TRUE(reading.done());
    EXPECT_THAT(reading.answer(), test::FailedWith(ErrorKind::kRefused));
    EXPECT_TRUE(instrument.written.empty());
}

TEST_F(ControlModeTest, WhatWaitedWhenThePanelTookControlFailsWithTheSentence) {
    panelSays("WS=PH02\r");
    const auto waiting = ask(read(7));
    line.bar(kPanelHasIt);
    arbiter.setMode(ControlMode::kPanel);
    core::deliverQueuedEvents();

    ASSERT_TRUE(waiting.done());
    EXPECT_EQ(waiting.answer().error().happened, QStringLiteral("The panel has control."));
}

TEST_F(ControlModeTest, AModeChangesWhenOurTransactionHasEnded) {
    const auto reading = ask(read(7));
    line.bar(kPanelHasIt);
    arbiter.setMode(ControlMode::kPanel);
    EXPECT_EQ(arbiter.mode(), ControlMode::kShared);
    panelSays("RG,8\r");
    EXPECT_EQ(instrumentHeard(), "RG,7\r");
    instrumentSays("7=10.2345\r\n>");

    EXPECT_TRUE(reading.done() && reading.answer().has_value());
    EXPECT_THAT(modes, ElementsAre(ControlMode::kPanel));
    EXPECT_EQ(instrumentHeard(), "RG,7\rRG,8\r");
}

TEST_F(ControlModeTest, AModeChangesWhenThePanelsTransactionHasEnded) {
    arbiter.setMode(ControlMode::kPanel);
    panelSays("WS=PH02\r");
    arbiter.setMode(ControlMode::kShared);
    const auto reading = ask(read(7));
    clock.advance(5s);
    EXPECT_EQ(arbiter.mode(), ControlMode::kPanel);
    EXPECT_EQ(instrumentHeard(), "WS=PH02\r");
    instrumentSays(">");

    EXPECT_EQ(arbiter.mode(), ControlMode::kShared);
    EXPECT_EQ(instrumentHeard(), "WS=PH02\rRG,7\r");
}

TEST_F(ControlModeTest, HalfACommandOnTheWireIsWaitedForBeforePmtsWrites) {
    arbiter.setMode(ControlMode::kPanel);
    panelSays("WG,26=1");
    arbiter.setMode(ControlMode::kComputer);
    const auto reading = ask(read(7));
    clock.advance(10s);
    EXPECT_EQ(instrumentHeard(), "WG,26=1");
    clock.advance(1s);  // the instrument has forgotten it by now

    EXPECT_EQ(arbiter.mode(), ControlMode::kComputer);
    EXPECT_EQ(instrumentHeard(), "WG,26=1RG,7\r");
}

TEST_F(ControlModeTest, AWaitingCommandOfThePanelGoesWithTheChangeToPanelModeInItsOrder) {
    const auto reading = ask(read(7));
    panelSays("RG,8\rRG,9\rRG");
    arbiter.setMode(ControlMode::kPanel);
    instrumentSays("7=10.2345\r\n>");
    panelSays(",5\r");

    EXPECT_EQ(instrumentHeard(), "RG,7\rRG,8\rRG,9\rRG,5\r");
}

TEST_F(ControlModeTest, AWaitingCommandOfThePanelIsSwallowedWhenTheComputerTakesControl) {
    const auto reading = ask(read(7));
    panelSays("RG,8\r");
    arbiter.setMode(ControlMode::kComputer);
    instrumentSays("7=10.2345\r\n>");

    EXPECT_EQ(instrumentHeard(), "RG,7\r");
    EXPECT_EQ(turns.at(0).outcome, Outcome::kSwallowed);
}

TEST_F(ControlModeTest, InPanelModeTheOwnerIsThePanelAllTheTime) {
    arbiter.setMode(ControlMode::kPanel);
    panelSays("RG,7\r");
    instrumentSays("7=10.2345\r\n>");

    EXPECT_THAT(owners, ElementsAre(std::pair(LineOwner::kPanel, core::Duration(0ms))));
}

TEST_F(ControlModeTest, BlocksThatNobodyAskedForAreStillHeardInPanelMode) {
    int heard = 0;
    line.on_unsolicited = [&](const protocol::Reply&) { ++heard; };
    arbiter.setMode(ControlMode::kPanel);
    instrumentSays("5=104\r\n>");

    EXPECT_EQ(heard, 1);
    EXPECT_EQ(panelHeard(), "5=104\r\n>");
}

TEST_F(ControlModeTest, WithoutABlockEndSilenceEndsAReplyOfThePanel) {
    line.setEndMark(std::nullopt);
    panelSays("RG,7\r");
    const auto reading = ask(read(8));
    instrumentSays("7=10.2345\r\n");
    clock.advance(499ms);
    EXPECT_EQ(instrumentHeard(), "RG,7\r");
    clock.advance(1ms);

    EXPECT_EQ(instrumentHeard(), "RG,7\rRG,8\r");
    EXPECT_EQ(turns.at(0).outcome, Outcome::kAnswered);
}

TEST_F(ControlModeTest, WithoutABlockEndSilenceIsTheAnswerToACommand) {
    line.setEndMark(std::nullopt);
    panelSays("WG,26=96.1684\r");
    clock.advance(500ms);

    EXPECT_EQ(turns.at(0).outcome, Outcome::kAnswered);
    EXPECT_EQ(arbiter.owner(), LineOwner::kIdle);
}

/// The bus under the control unit: blocks end with 0x04 and angles stream all the time.
class BusTest : public ArbiterTest {
protected:
    BusTest() {
        arbiter.setPanel(nullptr);
        line.setKeeper(&bus);
        bus.setPanel(&panel);
        bus.on_panel_turn = [this](const TransactionRecord& record) { turns.push_back(record); };
        line.setEndMark('\x04');
    }
    ~BusTest() override { line.setKeeper(nullptr); }

    Arbiter bus{instrument, clock, ArbiterSettings::forBus()};
};

TEST_F(BusTest, TheRunningStreamAnswersNobodyAndGoesToBoth) {
    int streamed = 0;
    bus.on_received = [&](std::string_view bytes) { streamed += static_cast<int>(bytes.size()); };
    const std::string block = "A,166=96.16838\rA,165=177.56115\x04";
    panelSays("WV,102=0\r");
    instrumentSays(block);
    EXPECT_EQ(bus.owner(), LineOwner::kPanel);
    instrumentSays("0.8\r\x04");

    EXPECT_EQ(bus.owner(), LineOwner::kIdle);
    EXPECT_EQ(panelHeard(), block + "0.8\r\x04");
    EXPECT_EQ(turns.at(0).received, "0.8\r\x04");
    EXPECT_EQ(streamed, static_cast<int>(block.size()));
}

TEST_F(BusTest, AProcessWithoutReplyEndsAtItsLimitAlthoughTheStreamGoesOn) {
    panelSays("WV,102=0\r");
    for (int i = 0; i < 12; ++i) {
        clock.advance(300ms);
        instrumentSays("A,166=96.16838\rA,165=177.56115\x04");
    }

    EXPECT_EQ(turns.at(0).outcome, Outcome::kTimedOut);
    EXPECT_EQ(bus.owner(), LineOwner::kIdle);
}

TEST_F(BusTest, BothTerminatorsOfThePanelAreOneCommand) {
    panelSays("WV,102=0\r\x04");
    EXPECT_EQ(instrumentHeard(), "WV,102=0\r\x04");
    instrumentSays("0.8\x04");

    EXPECT_EQ(bus.counts().panel_commands, 1U);
    EXPECT_EQ(bus.owner(), LineOwner::kIdle);
}

}  // namespace
}  // namespace pmts::scheduler
