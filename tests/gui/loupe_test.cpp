#include "field/loupe.hpp"

#include "test_frame.hpp"

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

class LoupeTest : public testing::Test {
protected:
    LoupeTest() {
        loupe.resize(320, 240);
        loupe.show();
        loupe.showAround(test::frameWithBluePixel(600, 300), QPointF(600, 300));
    }
    void wheel(int delta) {
        QWheelEvent event(QPointF(20, 30), loupe.mapToGlobal(QPointF(20, 30)), {}, QPoint(0, delta),
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&loupe, &event);
    }

    Loupe loupe;
    QSignalSpy clicked{&loupe, &ImageView::pixelClicked};
};

TEST_F(LoupeTest, ShowsThePlaceInTheMiddleEightTimesItsSize) {
    EXPECT_EQ(loupe.widgetFromImage(QPointF(600, 300)), QPointF(160, 120));
    EXPECT_EQ(loupe.widgetFromImage(QPointF(601, 300)), QPointF(168, 120));
    EXPECT_EQ(loupe.grab().toImage().pixelColor(157, 117), QColor(0, 0, 255));
}

TEST_F(LoupeTest, ClickTellsPartsOfAPixelOfThePicture) {
    QTest::mouseClick(&loupe, Qt::LeftButton, {}, QPoint(161, 125));
    ASSERT_EQ(clicked.count(), 1);
    const QPointF px = clicked[0][0].toPointF();
    EXPECT_NEAR(px.x(), 600 + 1.5 / 8, 1e-9);
    EXPECT_NEAR(px.y(), 300 + 5.5 / 8, 1e-9);
}

TEST_F(LoupeTest, WheelChangesTheMagnificationFromTwoToSixteenAndKeepsThePlace) {
    wheel(120);
    EXPECT_DOUBLE_EQ(loupe.zoom(), 10.0);
    wheel(120 * 20);
    EXPECT_DOUBLE_EQ(loupe.zoom(), 16.0);
    wheel(-120 * 40);
    EXPECT_DOUBLE_EQ(loupe.zoom(), 2.0);
    EXPECT_EQ(loupe.widgetFromImage(QPointF(600, 300)), QPointF(160, 120));
}

TEST_F(LoupeTest, PlaceAtThePicturesEdgeStaysInTheMiddle) {
    loupe.showAround(loupe.frame(), QPointF(0, 0));
    EXPECT_EQ(loupe.widgetFromImage(QPointF(0, 0)), QPointF(160, 120));
}

TEST_F(LoupeTest, NewerFrameIsShownAtTheSamePlace) {
    loupe.follow(test::frameWithBluePixel(601, 300));
    EXPECT_EQ(loupe.place(), QPointF(600, 300));
    EXPECT_EQ(loupe.grab().toImage().pixelColor(165, 117), QColor(0, 0, 255));
}

}  // namespace
}  // namespace pmts::gui
