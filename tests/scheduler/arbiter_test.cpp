#include "arbiter_fixture.hpp"

namespace pmts::scheduler {
namespace {

TEST_F(ArbiterTest, APanelCommandGoesWhenItsTerminatorHasCome) {
    for (const char* part : {"R", "G", ",7"}) {
        panelSays(part);
    }
    EXPECT_TRUE(instrument.written.empty());
    panelSays("\r");

    EXPECT_EQ(instrumentHeard(), "RG,7\r");
    EXPECT_EQ(arbiter.owner(), LineOwner::kPanel);
}

TEST_F(ArbiterTest, TheReplyGoesToThePanelByteByByte) {
    panelSays("RG,7\r\n");
    instrumentSays("7=10");
    EXPECT_EQ(panelHeard(), "7=10");
    instrumentSays(".2345\r\n>");

    EXPECT_EQ(panelHeard(), "7=10.2345\r\n>");
    EXPECT_EQ(instrumentHeard(), "RG,7\r\n");  // the line feed too
    EXPECT_EQ(arbiter.owner(), LineOwner::kIdle);
    EXPECT_EQ(line.counts().unsolicited, 0U);
}

TEST_F(ArbiterTest, ALineFeedThatComesLaterStillFollowsItsCommand) {
    panelSays("RG,7\r");
    panelSays("\n");

    EXPECT_EQ(instrumentHeard(), "RG,7\r\n");
}

TEST_F(ArbiterTest, ALineFeedAfterTheAnswerWaitsForTheNextCommand) {
    panelSays("TG\r");
    instrumentSays(">");
    panelSays("\n");
    const auto reading = ask(read(7));
    instrumentSays("7=10.2345\r\n>");
    panelSays("RG,8\r");

    EXPECT_EQ(instrumentHeard(), "TG\rRG,7\r\nRG,8\r");
}

TEST_F(ArbiterTest, PmtsWaitsForTheEndOfThePanelsTransaction) {
    panelSays("RG,7\r");
    const auto reading = ask(read(8));
    clock.advance(100ms);
    EXPECT_EQ(instrumentHeard(), "RG,7\r");
    instrumentSays("7=10.2345\r\n>");
    EXPECT_EQ(instrumentHeard(), "RG,7\rRG,8\r");
    instrumentSays("8=99.0000\r\n>");

    ASSERT_TRUE(reading.done() && reading.answer().has_value());
    EXPECT_EQ(reading.answer()->find(8)->data, "99.0000");
    EXPECT_EQ(panelHeard(), "7=10.2345\r\n>");
}

TEST_F(ArbiterTest, ThePanelWaitsForTheEndOfOurTransactionAndHearsNothingOfIt) {
    const auto reading = ask(read(8));
    panelSays("RG,7\r");
    EXPECT_EQ(instrumentHeard(), "RG,8\r");
    instrumentSays("8=99.0000\r\n>");

    EXPECT_EQ(instrumentHeard(), "RG,8\rRG,7\r");
    EXPECT_EQ(panelHeard(), "");
}

TEST_F(ArbiterTest, WhenBothWaitTheyGoInTurn) {
    const std::vector<Watched> ours{ask(read(1)), ask(read(1)), ask(read(1))};
    panelSays("RG,2\rRG,2\rRG,2\r");
    arbiter.setMode(ControlMode::kShared);
    instrument.respond = [](const std::string& sent) { return sent.substr(3, 1) + "=5\r\n>"; };
    instrumentSays("1=5\r\n>");
    clock.advance(1s);

    EXPECT_EQ(instrumentHeard().substr(0, 10), "RG,1\rRG,2\r");
    EXPECT_TRUE(ours[2].done() && ours[2].answer().has_value());
    EXPECT_EQ(panelHeard(), "2=5\r\n>2=5\r\n>2=5\r\n>");
}

TEST_F(ArbiterTest, APanelThatNeverStopsAskingDoesNotStarvePmts) {
    panel.respond = [this](const std::string&) {
        panel.say("RG,2\r");
        return std::nullopt;
    };
    instrument.respond = [](const std::string& sent) { return sent.substr(3, 1) + "=5\r\n>"; };
    panelSays("RG,2\rRG,2\rRG,2\rRG,2\r");
    const auto reading = ask(read(1));
    clock.advance(200ms);

    ASSERT_TRUE(reading.done());
    EXPECT_TRUE(reading.answer().has_value());
}

TEST_F(ArbiterTest, PmtsThatNeverStopsAskingDoesNotStarveThePanel) {
    instrument.respond = [](const std::string& sent) { return sent.substr(3, 1) + "=5\r\n>"; };
    std::vector<Watched> ours;
    for (int i = 0; i < 50; ++i) {
        ours.push_back(ask(read(1)));
    }
    panelSays("RG,2\r");
    clock.advance(100ms);

    EXPECT_EQ(panelHeard(), "2=5\r\n>");
}

TEST_F(ArbiterTest, BothStartAtOnceAndNobodyIsMixedUp) {
    instrument.respond = [](const std::string& sent) { return sent.substr(3, 1) + "=5\r\n>"; };
    panel.say("RG,2\r");
    const auto reading = ask(read(1));
    clock.advance(1s);

    EXPECT_THAT(instrument.written, ElementsAre("RG,1\r", "RG,2\r"));
    EXPECT_EQ(reading.answer()->find(1)->data, "5");
    EXPECT_EQ(panelHeard(), "2=5\r\n>");
}

TEST_F(ArbiterTest, OurStopDoesNotGoIntoATransactionOfThePanel) {
    panelSays("WS=PH02V02\r");
    auto stop = command("PG,3=0\r");
    stop.priority = Priority::kStop;
    stop.interrupts = true;
    const auto stopped = ask(stop);
    EXPECT_EQ(instrumentHeard(), "WS=PH02V02\r");
    instrumentSays(">");

    EXPECT_EQ(instrumentHeard(), "WS=PH02V02\rPG,3=0\r");
}

TEST_F(ArbiterTest, ThePanelMayStopWhatItBegan) {
    panelSays("WS=PH02V02\r");
    const auto waiting = ask(read(1));
    panelSays("PG,3=0\r");
    EXPECT_EQ(instrumentHeard(), "WS=PH02V02\rPG,3=0\r");
    instrumentSays("190\r\n>");
    EXPECT_EQ(arbiter.owner(), LineOwner::kPanel);  // its second answer is still owed
    instrumentSays(">");

    EXPECT_EQ(instrumentHeard(), "WS=PH02V02\rPG,3=0\rRG,1\r");
    EXPECT_EQ(panelHeard(), "190\r\n>>");
}

TEST_F(ArbiterTest, ASilentInstrumentEndsAPanelsTurnAtItsLimit) {
    panelSays("RG,7\r");
    const auto reading = ask(read(8));
    clock.advance(2999ms);
    EXPECT_EQ(instrumentHeard(), "RG,7\r");
    clock.advance(1ms);

    EXPECT_EQ(instrumentHeard(), "RG,7\rRG,8\r");
    ASSERT_EQ(turns.size(), 1U);
    EXPECT_EQ(turns[0].outcome, Outcome::kTimedOut);
    EXPECT_EQ(arbiter.counts().panel_timed_out, 1U);
}

TEST_F(ArbiterTest, AMotionOfThePanelIsGivenItsTime) {
    panelSays("WS=PH02V02\r");
    const auto reading = ask(read(8));
    clock.advance(30s);
    EXPECT_EQ(instrumentHeard(), "WS=PH02V02\r");
    instrumentSays(">");

    EXPECT_EQ(instrumentHeard(), "WS=PH02V02\rRG,8\r");
}

TEST_F(ArbiterTest, APanelUnpluggedInMidTransactionLeavesTheLineWhenItsAnswerHasCome) {
    panelSays("RG,7\r");
    arbiter.setPanel(nullptr);
    const auto reading = ask(read(8));
    EXPECT_EQ(instrumentHeard(), "RG,7\r");
    instrumentSays("7=10.2345\r\n>");

    EXPECT_EQ(instrumentHeard(), "RG,7\rRG,8\r");
    EXPECT_EQ(turns.at(0).received, "7=10.2345\r\n>");
    EXPECT_EQ(line.counts().unsolicited, 0U);
}

TEST_F(ArbiterTest, APanelUnpluggedInMidCommandLeavesNothingOnTheLine) {
    panelSays("WG,26=12");
    arbiter.setPanel(nullptr);
    arbiter.setPanel(&panel);
    panelSays("RG,7\r");

    EXPECT_EQ(instrumentHeard(), "RG,7\r");
    EXPECT_EQ(turns.at(0).sent, "WG,26=12");
    EXPECT_EQ(turns.at(0).outcome, Outcome::kSwallowed);
}

TEST_F(ArbiterTest, HalfACommandIsForgottenAsTheInstrumentForgetsIt) {
    panelSays("WG,26=12");
    clock.advance(12s);
    panelSays("RG,7\r");

    EXPECT_EQ(instrumentHeard(), "RG,7\r");
}

TEST_F(ArbiterTest, WhatNobodyAskedForGoesToBoth) {
    std::string heard;
    line.on_unsolicited = [&](const protocol::Reply& reply) { heard = reply.raw; };
    instrumentSays("5=104\r\n7=10.2345\r\n>");

    EXPECT_EQ(panelHeard(), "5=104\r\n7=10.2345\r\n>");
    EXPECT_EQ(heard, "5=104\r\n7=10.2345\r\n");
    EXPECT_EQ(arbiter.counts().unsolicited, 1U);
}

TEST_F(ArbiterTest, WhatNobodyAskedForInOurTransactionReachesThePanelToo) {
    const auto reading = ask(read(8));
    instrumentSays("37=100.000\r\n>8=99.0000\r\n>");

    EXPECT_TRUE(reading.done() && reading.answer().has_value());
    EXPECT_EQ(panelHeard(), "37=100.000\r\n>");
}

TEST_F(ArbiterTest, WhatNobodyAskedForInATransactionOfThePanelReachesPmtsToo) {
    std::string heard;
    line.on_unsolicited = [&](const protocol::Reply& reply) { heard = reply.raw; };
    panelSays("RG,7\r");
    instrumentSays("37=100.000\r\n>7=10.2345\r\n>");

    EXPECT_EQ(heard, "37=100.000\r\n");
    EXPECT_EQ(panelHeard(), "37=100.000\r\n>7=10.2345\r\n>");
    EXPECT_EQ(arbiter.owner(), LineOwner::kIdle);
}

TEST_F(ArbiterTest, ABlockThatBeganBeforeTheCommandIsNotItsAnswer) {
    instrumentSays("37=100");
    panelSays("RG,37\r");
    instrumentSays(".000\r\n>");
    EXPECT_EQ(arbiter.owner(), LineOwner::kPanel);
    instrumentSays("37=100.000\r\n>");

    EXPECT_EQ(arbiter.owner(), LineOwner::kIdle);
}

TEST_F(ArbiterTest, OurAnswerThatComesTwiceIsNotTakenForThePanels) {
    const auto reading = ask(read(8));
    panelSays("RG,7\r");
    instrumentSays("8=99.0000\r\n>8=99.0000\r\n>");
    EXPECT_EQ(arbiter.owner(), LineOwner::kPanel);
    instrumentSays("7=10.2345\r\n>");

    EXPECT_EQ(arbiter.owner(), LineOwner::kIdle);
    EXPECT_EQ(turns.at(0).received, "7=10.2345\r\n>");
}

TEST_F(ArbiterTest, AStrayEndMarkDoesNotEndAQuestionOfThePanel) {
    panelSays("RG,7\r");
    instrumentSays(">");
    EXPECT_EQ(arbiter.owner(), LineOwner::kPanel);
    instrumentSays("7=10.2345\r\n>");

    EXPECT_EQ(panelHeard(), ">7=10.2345\r\n>");
    EXPECT_EQ(arbiter.owner(), LineOwner::kIdle);
}

TEST_F(ArbiterTest, AFileThatThePanelLoadsIsOneTransaction) {
    panelSays("LM=DEMO\r");
    const auto reading = ask(read(8));
    instrumentSays("*");
    panelSays("5=1\r\n4=WALL\r\n");
    panelSays(">");
    EXPECT_EQ(instrumentHeard(), "LM=DEMO\r5=1\r\n4=WALL\r\n>");
    instrumentSays("\r\n>");

    EXPECT_EQ(instrumentHeard(), "LM=DEMO\r5=1\r\n4=WALL\r\n>RG,8\r");
}

TEST_F(ArbiterTest, SaysWhoHasTheLineAndSinceWhen) {
    clock.advance(1s);
    panelSays("RG,7\r");
    clock.advance(20ms);
    instrumentSays("7=10.2345\r\n>");
    const auto reading = ask(read(8));

    EXPECT_THAT(owners, ElementsAre(std::pair(LineOwner::kPanel, core::Duration(1s)),
                                    std::pair(LineOwner::kIdle, core::Duration(1020ms)),
                                    std::pair(LineOwner::kComputer, core::Duration(1020ms))));
}

TEST_F(ArbiterTest, EachTurnOfThePanelIsRecordedWithItsBytesAndTimes) {
    const auto reading = ask(read(8));
    panelSays("RG,7\r");
    clock.advance(30ms);
    instrumentSays("8=99.0000\r\n>");
    clock.advance(40ms);
    instrumentSays("7=10.2345\r\n>");

    ASSERT_EQ(turns.size(), 1U);
    EXPECT_EQ(turns[0].sent, "RG,7\r");
    EXPECT_EQ(turns[0].received, "7=10.2345\r\n>");
    EXPECT_EQ(turns[0].master, Master::kPanel);
    EXPECT_EQ(turns[0].sent_at - turns[0].queued_at, core::Duration(30ms));
    EXPECT_EQ(turns[0].finished_at - turns[0].sent_at, core::Duration(40ms));
}

TEST_F(ArbiterTest, ALostInstrumentEndsThePanelsTurnAndWhatComesIsSwallowed) {
    panelSays("RG,7\r");
    instrument.unplug();
    panelSays("RG,8\r");

    EXPECT_EQ(instrumentHeard(), "RG,7\r");
    EXPECT_EQ(turns.at(0).outcome, Outcome::kFailed);
    EXPECT_EQ(turns.at(1).sent, "RG,8\r");
    EXPECT_EQ(arbiter.owner(), LineOwner::kIdle);
}

}  // namespace
}  // namespace pmts::scheduler
