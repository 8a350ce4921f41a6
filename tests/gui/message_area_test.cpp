#include "window/message_area.hpp"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

app::Message cablePulled() {
    app::Message message;
    message.id = 7;
    message.kind = app::MessageKind::kProblem;
    message.happened = QStringLiteral("The instrument is gone.");
    message.remedy = QStringLiteral("Check the cable.");
    message.action = app::MessageAction::kOpenConnectionPage;
    message.action_text = QStringLiteral("Open connection page");
    message.details = QStringLiteral("/dev/ttyUSB0: read error");
    return message;
}

class MessageAreaTest : public testing::Test {
protected:
    MessageAreaTest() {
        window.resize(900, 300);
        area.setGeometry(0, 0, 900, 200);
        area.showBars({cablePulled()});
        window.show();
    }

    QWidget window;
    MessageArea area{&window};
};

TEST_F(MessageAreaTest, ShowsWhatHappenedAndWhatToDo) {
    EXPECT_TRUE(area.isVisible());
    EXPECT_EQ(area.findChild<QLabel*>(QStringLiteral("happened"))->text(),
              QStringLiteral("The instrument is gone."));
    EXPECT_EQ(area.findChild<QLabel*>(QStringLiteral("remedy"))->text(), QStringLiteral("Check the cable."));
}

TEST_F(MessageAreaTest, DetailsAreFoldedUntilAsked) {
    auto* const details = area.findChild<QLabel*>(QStringLiteral("details"));
    EXPECT_FALSE(details->isVisible());
    QTest::mouseClick(area.findChild<QToolButton*>(QStringLiteral("more")), Qt::LeftButton);
    EXPECT_TRUE(details->isVisible());
}

TEST_F(MessageAreaTest, ItsButtonAsksForItsAction) {
    QSignalSpy chosen(&area, &MessageArea::actionChosen);
    QTest::mouseClick(area.findChild<QPushButton*>(QStringLiteral("act")), Qt::LeftButton);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.first().first().value<app::MessageAction>(), app::MessageAction::kOpenConnectionPage);
}

TEST_F(MessageAreaTest, DismissTellsWhichOne) {
    QSignalSpy dismissed(&area, &MessageArea::dismissed);
    QTest::mouseClick(area.findChild<QToolButton*>(QStringLiteral("dismiss")), Qt::LeftButton);
    ASSERT_EQ(dismissed.count(), 1);
    EXPECT_EQ(dismissed.first().first().toULongLong(), 7U);
}

TEST_F(MessageAreaTest, GoesAwayWithItsLastMessage) {
    area.showBars({});
    EXPECT_FALSE(area.isVisible());
}

TEST_F(MessageAreaTest, TheSameAgainIsCounted) {
    app::Message again = cablePulled();
    again.count = 3;
    area.showBars({again});
    const auto labels = area.findChildren<QLabel*>(QStringLiteral("happened"));
    EXPECT_TRUE(labels.back()->text().contains(u'3'));
}

}  // namespace
}  // namespace pmts::gui
