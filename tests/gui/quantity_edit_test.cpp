#include "parts/quantity_edit.hpp"

#include <QSignalSpy>
#include <QTest>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

class QuantityEditTest : public testing::Test {
protected:
    void typeAndLeave(const QString& text) {
        edit.selectAll();
        QTest::keyClicks(&edit, text);
        QTest::keyClick(&edit, Qt::Key_Return);
    }

    QuantityEdit edit;
};

TEST_F(QuantityEditTest, FeetAreShownInMetres) {
    typeAndLeave(QStringLiteral("10 ft"));
    EXPECT_EQ(edit.text(), QStringLiteral("3.048 m"));
}

TEST_F(QuantityEditTest, ArithmeticIsWorkedOut) {
    typeAndLeave(QStringLiteral("2*0.8"));
    EXPECT_EQ(edit.text(), QStringLiteral("1.600 m"));
}

TEST_F(QuantityEditTest, MinutesAreShownInGon) {
    edit.setKind(QuantityEdit::Kind::kAngle);
    typeAndLeave(QStringLiteral("54'"));  // 0.9 degrees
    EXPECT_EQ(edit.text(), QStringLiteral("1.0000 gon"));
}

TEST_F(QuantityEditTest, NonsenseStaysAndIsMarked) {
    QSignalSpy understood(&edit, &QuantityEdit::understood);
    typeAndLeave(QStringLiteral("about two"));
    EXPECT_EQ(edit.text(), QStringLiteral("about two"));
    EXPECT_FALSE(edit.isUnderstood());
    EXPECT_FALSE(edit.toolTip().isEmpty());
    EXPECT_EQ(understood.count(), 0);
}

TEST_F(QuantityEditTest, TypingAgainTakesTheMarkAway) {
    typeAndLeave(QStringLiteral("about two"));
    QTest::keyClick(&edit, Qt::Key_Backspace);
    EXPECT_TRUE(edit.isUnderstood());
}

TEST_F(QuantityEditTest, AChangeOfUnitsRewritesTheSameLength) {
    typeAndLeave(QStringLiteral("3.048"));
    edit.setUnits({.length_unit = app::LengthUnit::kFoot});
    EXPECT_EQ(edit.text(), QStringLiteral("10.000 ft"));
}

}  // namespace
}  // namespace pmts::gui
