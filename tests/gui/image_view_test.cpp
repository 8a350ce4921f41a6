#include "field/image_view.hpp"

#include "test_frame.hpp"

#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

using testing::DoubleEq;
using testing::DoubleNear;

QPointF lastPlace(QSignalSpy& spy) { return spy.takeLast().at(0).toPointF(); }

class ImageViewTest : public testing::Test {
protected:
    ImageViewTest() {
        view.resize(1280, 720);
        view.setFrame(test::frameWithBluePixel(10, 20));
        view.show();
    }

    ImageView view;
    QSignalSpy clicked{&view, &ImageView::pixelClicked};
};

TEST_F(ImageViewTest, TellsWholePixelsAtOneToOne) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(10, 20));
    ASSERT_EQ(clicked.count(), 1);
    EXPECT_EQ(lastPlace(clicked), QPointF(10, 20));  // the centre of the top-left pixel is (0, 0)
}

TEST_F(ImageViewTest, ShowsThePixelWhereAClickFindsIt) {
    EXPECT_EQ(view.grab().toImage().pixelColor(10, 20), QColor(0, 0, 255));
}

TEST_F(ImageViewTest, HalfSizeViewTellsTheMiddleOfFourPixels) {
    view.resize(640, 360);
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(1, 1));
    EXPECT_EQ(lastPlace(clicked), QPointF(2.5, 2.5));
}

TEST_F(ImageViewTest, BandsBesideThePictureAreNoPixels) {
    view.resize(1280, 1000);
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(640, 20));
    EXPECT_EQ(clicked.count(), 0);
}

TEST_F(ImageViewTest, ZoomKeepsThePixelUnderTheCursor) {
    const QPointF at(300, 200);
    const QPointF before = view.imageFromWidget(at);
    view.zoomAbout(at, 5.0);
    EXPECT_THAT(view.imageFromWidget(at).x(), DoubleNear(before.x(), 1e-9));
    EXPECT_THAT(view.imageFromWidget(at).y(), DoubleNear(before.y(), 1e-9));
}

TEST_F(ImageViewTest, ZoomEndsAtOneAndEight) {
    view.setZoom(100.0);
    EXPECT_THAT(view.zoom(), DoubleEq(8.0));
    view.setZoom(0.1);
    EXPECT_THAT(view.zoom(), DoubleEq(1.0));
}

TEST_F(ImageViewTest, WheelZoomsInTowardsTheCursor) {
    QWheelEvent wheel(QPointF(100, 100), view.mapToGlobal(QPointF(100, 100)), {}, QPoint(0, 120),
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &wheel);
    EXPECT_THAT(view.zoom(), DoubleEq(1.25));
}

TEST_F(ImageViewTest, PinchZoomsAboutTheFingers) {
    const QPointF at(300, 200);
    const QPointF before = view.imageFromWidget(at);
    QNativeGestureEvent pinch(Qt::ZoomNativeGesture, QPointingDevice::primaryPointingDevice(), 2, at, at,
                              view.mapToGlobal(at), 0.5, QPointF());
    QCoreApplication::sendEvent(&view, &pinch);
    EXPECT_THAT(view.zoom(), DoubleEq(1.5));
    EXPECT_THAT(view.imageFromWidget(at).x(), DoubleNear(before.x(), 1e-9));
}

TEST_F(ImageViewTest, DraggingPansAndIsNoClick) {
    view.setZoom(4.0);
    const QPointF before = view.imageFromWidget(QPointF(640, 360));
    QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(640, 360));
    QTest::mouseMove(&view, QPoint(540, 360));
    QMouseEvent drag(QEvent::MouseMove, QPointF(540, 360), view.mapToGlobal(QPointF(540, 360)),
                     Qt::LeftButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&view, &drag);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(540, 360));
    EXPECT_EQ(clicked.count(), 0);
    EXPECT_THAT(view.imageFromWidget(QPointF(640, 360)).x(), DoubleNear(before.x() + 25.0, 1e-6));
}

TEST_F(ImageViewTest, NeverPansBeyondThePicture) {
    view.setZoom(2.0);
    view.zoomAbout(QPointF(0, 0), 1.0);
    EXPECT_THAT(view.imageFromWidget(QPointF(0, 0)).x(), DoubleNear(-0.5, 1e-9));
}

TEST_F(ImageViewTest, DoubleClickIsToldWithItsPixel) {
    QSignalSpy twice(&view, &ImageView::pixelDoubleClicked);
    QTest::mouseDClick(&view, Qt::LeftButton, {}, QPoint(77, 88));
    ASSERT_EQ(twice.count(), 1);
    EXPECT_EQ(lastPlace(twice), QPointF(77, 88));
}

TEST_F(ImageViewTest, TellsEachPaintedFrameOnce) {
    QSignalSpy painted(&view, &ImageView::framePainted);
    view.setFrame(test::frameWithBluePixel(1, 1));
    (void)view.grab();
    view.setCaption(QStringLiteral("HA 177.5612"));
    (void)view.grab();
    EXPECT_EQ(painted.count(), 1);
}

TEST_F(ImageViewTest, DrawsTheReticleAtItsPixel) {
    const QImage before = view.grab().toImage();
    view.setOverlay({.reticle = QPointF(640, 360)});
    const QImage after = view.grab().toImage();
    EXPECT_NE(after.pixelColor(640 + 20, 360), before.pixelColor(640 + 20, 360));
    EXPECT_EQ(after.pixelColor(640 + 60, 360), before.pixelColor(640 + 60, 360));
}

TEST_F(ImageViewTest, EveryStateOfATargetLooksDifferent) {
    std::vector<QImage> looks;
    for (const TargetLook look : {TargetLook::kClicked, TargetLook::kQueued, TargetLook::kTurning,
                                  TargetLook::kRecentring, TargetLook::kArrived, TargetLook::kLost}) {
        view.setOverlay({.target = ImageOverlay::Target{QPointF(640, 360), look, {}}});
        looks.push_back(
            view.grab(QRect(610, 330, 60, 60)).toImage().convertToFormat(QImage::Format_Grayscale8));
    }
    for (std::size_t a = 0; a < looks.size(); ++a) {
        for (std::size_t b = a + 1; b < looks.size(); ++b) {
            EXPECT_NE(looks[a], looks[b]) << a << " and " << b << " differ by colour only";
        }
    }
}

}  // namespace
}  // namespace pmts::gui
