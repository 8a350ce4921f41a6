#include "pmts/app/desk/message_centre.hpp"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace pmts::app {
namespace {

core::Error fullDisk() {
    return {.kind = core::ErrorKind::kFile, .happened = QStringLiteral("The disk is full."),
            .remedy = QStringLiteral("Make room."), .info_code = 35, .detail = QStringLiteral("/jobs/a.gpkg")};
}

TEST(MessageCentreTest, GoodNewsGoBySoTheyLeaveNoBar) {
    MessageCentre messages;
    QSignalSpy shown(&messages, &MessageCentre::toastShown);
    messages.toast(QStringLiteral("Recorded."));
    EXPECT_EQ(shown.size(), 1);
    EXPECT_TRUE(messages.bars().empty());
}

TEST(MessageCentreTest, ProblemStaysWithRemedyActionAndFoldedDetails) {
    MessageCentre messages;
    messages.report(fullDisk(), MessageAction::kRetryRecord, QStringLiteral("record"));
    ASSERT_EQ(messages.bars().size(), 1U);
    const Message& bar = messages.bars().front();
    EXPECT_EQ(bar.remedy, QStringLiteral("Make room."));
    EXPECT_EQ(bar.action_text, QStringLiteral("Record again"));
    EXPECT_EQ(bar.details, QStringLiteral("info 35, /jobs/a.gpkg"));
    EXPECT_FALSE(bar.happened.contains(QStringLiteral("35"))) << "no bare code for people";
}

TEST(MessageCentreTest, SameTroubleAgainCountsUpInsteadOfPilingUp) {
    MessageCentre messages;
    for (int i = 0; i < 500; ++i) {
        messages.report(fullDisk());
    }
    ASSERT_EQ(messages.bars().size(), 1U);
    EXPECT_EQ(messages.bars().front().count, 500);
}

TEST(MessageCentreTest, SolvedTopicTakesItsBarAwayAndLeavesTheOthers) {
    MessageCentre messages;
    messages.report(fullDisk(), MessageAction::kNone, QStringLiteral("record"));
    messages.warn(QStringLiteral("The camera is gone."), QString(), MessageAction::kNone, QStringLiteral("camera"));
    messages.solve(QStringLiteral("record"));
    ASSERT_EQ(messages.bars().size(), 1U);
    EXPECT_EQ(messages.bars().front().topic, QStringLiteral("camera"));
}

TEST(MessageCentreTest, DismissedBarIsGone) {
    MessageCentre messages;
    const quint64 id = messages.report(fullDisk());
    messages.dismiss(id);
    EXPECT_TRUE(messages.bars().empty());
}

TEST(MessageCentreTest, EveryActionHasAWordForItsButton) {
    for (const auto action : {MessageAction::kOpenConnectionPage, MessageAction::kOpenJob, MessageAction::kRetryRecord,
                              MessageAction::kShowLog, MessageAction::kOpenSettings, MessageAction::kReconnect,
                              MessageAction::kAcceptBlock, MessageAction::kRecordSameId}) {
        EXPECT_FALSE(actionText(action).isEmpty());
    }
}

}  // namespace
}  // namespace pmts::app
