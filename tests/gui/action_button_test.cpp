#include "parts/action_button.hpp"

#include <QAction>
#include <QSignalSpy>
#include <QTest>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

class ActionButtonTest : public testing::Test {
protected:
    ActionButtonTest() {
        action.setShortcut(Qt::Key_C);
        button.setAction(&action);
        button.show();
    }

    QAction action{QStringLiteral("Capture")};
    ActionButton button;
};

TEST_F(ActionButtonTest, IsLargeEnoughForAGlove) {
    EXPECT_GE(button.sizeHint().height(), 44);
    EXPECT_GE(button.sizeHint().width(), 44);
    EXPECT_GE(button.minimumSizeHint().height(), 44);
    EXPECT_GE(button.minimumSizeHint().width(), 44);
}

TEST_F(ActionButtonTest, GrowsWithItsText) {
    const QSize before = button.sizeHint();
    QFont larger = button.font();
    larger.setPointSizeF(larger.pointSizeF() * 1.4);
    button.setFont(larger);
    EXPECT_GT(button.sizeHint().width(), before.width());
    EXPECT_GE(button.sizeHint().height(), before.height());
}

TEST_F(ActionButtonTest, TriggersItsActionAndLeavesTheFocusAlone) {
    QSignalSpy triggered(&action, &QAction::triggered);
    QTest::mouseClick(&button, Qt::LeftButton);
    EXPECT_EQ(triggered.count(), 1);
    EXPECT_FALSE(button.hasFocus());
}

TEST_F(ActionButtonTest, TellsItsNameAndKeyToAScreenReader) {
    EXPECT_EQ(button.accessibleName(), QStringLiteral("Capture"));
    EXPECT_TRUE(button.accessibleDescription().contains(u'C'));
}

TEST(KeyCap, IsNamedAsOnTheKeyboard) {
    EXPECT_EQ(keyCapText(Qt::Key_Return), QStringLiteral("Enter"));
    EXPECT_EQ(keyCapText(Qt::Key_Space), QStringLiteral("Space"));
    EXPECT_EQ(keyCapText(Qt::Key_Escape), QStringLiteral("Esc"));
    EXPECT_EQ(keyCapText(Qt::Key_D), QStringLiteral("D"));
    EXPECT_EQ(keyCapText({}), QString());
}

}  // namespace
}  // namespace pmts::gui
