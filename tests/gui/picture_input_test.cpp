#include "field/picture_input.hpp"

#include "bench_fixture.hpp"
#include "field/field_actions.hpp"
#include "picture_source.hpp"

#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <opencv2/imgproc.hpp>

namespace pmts::gui {
namespace {

/// A dark window in the wall, its corner at (399.5, 299.5).
cv::Mat wallWithWindow() {
    cv::Mat picture = test::greyPicture();
    cv::rectangle(picture, cv::Rect(400, 300, 200, 150), cv::Scalar::all(50), cv::FILLED);
    return picture;
}

class PictureInputTest : public test::WindowFixture {
protected:
    PictureInputTest() : actions(&keys), tools(actions) {
        bench->live.setSource(std::make_unique<test::PictureSource>(wallWithWindow()));
        view.resize(1280, 720);
        view.setFrame(bench->live.scene().frame);
        view.show();
        input = new PictureInput(view, app::Picture::kLive, *bench, tools);
    }

    void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(&view, Qt::LeftButton, modifiers, at);
    }
    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&view, Qt::LeftButton, modifiers, from);
        for (const QPoint& at : {(from + to) / 2, to}) {
            QMouseEvent move(QEvent::MouseMove, QPointF(at), view.mapToGlobal(QPointF(at)), Qt::LeftButton,
                             Qt::LeftButton, modifiers);
            QCoreApplication::sendEvent(&view, &move);
        }
    }
    void release(const QPoint& at) { QTest::mouseRelease(&view, Qt::LeftButton, {}, at); }
    void drawPoint(const QPointF& px, PointLook look = PointLook::kRecorded) {
        view.setOverlay({.points = {{.px = px, .label = QStringLiteral("104"), .look = look, .row_id = 11}}});
    }
    [[nodiscard]] QPushButton* choice(const QString& text) const {
        for (QPushButton* button : view.findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text() == text) {
                return button;
            }
        }
        return nullptr;
    }
    [[nodiscard]] const std::optional<app::Target>& target() const { return bench->targeting.target(); }

    QWidget keys;
    FieldActions actions;
    PictureTools tools;
    ImageView view;
    PictureInput* input = nullptr;
};

TEST_F(PictureInputTest, ClickOnEmptyPictureAims) {
    click({800, 200});
    ASSERT_TRUE(target().has_value());
    EXPECT_EQ(target()->state, app::MoveState::kAimed);
}

TEST_F(PictureInputTest, ClickNearADrawnPointChoosesItAndOffersToTurn) {
    drawPoint({800, 200});
    QSignalSpy chosen(input, &PictureInput::pointChosen);
    click({809, 203});
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen[0][0].toLongLong(), 11);
    EXPECT_FALSE(target().has_value()) << "it aimed at the picture";
    ASSERT_NE(choice(QStringLiteral("Turn to 104")), nullptr);
    EXPECT_GE(choice(QStringLiteral("Turn to 104"))->height(), 44);
    click({300, 600});
    EXPECT_EQ(choice(QStringLiteral("Turn to 104")), nullptr) << "a click elsewhere leaves it";
}

TEST_F(PictureInputTest, ClickInAnotherPictureEndsTheOffer) {
    ImageView other;
    other.resize(640, 360);
    other.setFrame(view.frame());
    new PictureInput(other, app::Picture::kStill, *bench, tools);
    drawPoint({800, 200});
    click({800, 200});
    QTest::mouseClick(&other, Qt::LeftButton, {}, QPoint(20, 20));
    EXPECT_EQ(choice(QStringLiteral("Turn to 104")), nullptr);
}

TEST_F(PictureInputTest, ControlClickAimsWhereAPointIsDrawn) {
    drawPoint({800, 200});
    click({803, 201}, Qt::ControlModifier);
    EXPECT_TRUE(target().has_value());
}

TEST_F(PictureInputTest, ReachOfAPointIsInScreenPixelsNotInThePictures) {
    drawPoint({640, 360});
    view.setZoom(8.0);
    QSignalSpy chosen(input, &PictureInput::pointChosen);
    click({640 + 40, 360});  // 5 px of the picture, 40 of the screen
    EXPECT_EQ(chosen.count(), 0);
    EXPECT_TRUE(target().has_value());
}

TEST_F(PictureInputTest, SnappedClickLandsOnTheCorner) {
    bench->snap.setOn(true);
    QSignalSpy shown(&bench->snap, &app::SnapPresenter::spotChanged);
    QTest::mouseMove(&view, QPoint(405, 294));
    Q_EMIT view.hovered(QPointF(405, 294));
    ASSERT_TRUE(shown.wait());
    ASSERT_TRUE(view.toolOverlay().snap.has_value());
    EXPECT_EQ(view.toolOverlay().snap->look, SnapLook::kCorner);
    click({405, 294});
    const auto corner = bench->routines.pdata(399.5, 299.5);
    ASSERT_TRUE(target() && corner);
    EXPECT_NEAR((target()->pointing.ha - corner->ha).mgon(), 0.0, 15.0);  // 0.3 px
}

TEST_F(PictureInputTest, DragDrawsALineThatSticksToTheReticle) {
    const QPoint reticle = bench->live.scene().reticle_px->toPoint();
    drag({300, 500}, reticle + QPoint(9, 6));
    ASSERT_TRUE(view.toolOverlay().drag.has_value());
    EXPECT_EQ(view.toolOverlay().drag->p1(), QPointF(300, 500));
    EXPECT_EQ(view.toolOverlay().drag->p2(), *bench->live.scene().reticle_px);
    release(reticle + QPoint(9, 6));
    EXPECT_FALSE(view.toolOverlay().drag.has_value());
    const auto spot = bench->routines.pdata(300, 500);
    ASSERT_TRUE(target().has_value());
    EXPECT_NEAR((target()->pointing.ha - spot->ha).cc(), 0.0, 0.1);
}

TEST_F(PictureInputTest, DragElsewhereAsksForTheTurnThatBringsTheSpotThere) {
    drag({300, 500}, {500, 500});
    release({500, 500});
    ASSERT_TRUE(target().has_value());
    EXPECT_LT(target()->pointing.ha.gon(), 100.0) << "the picture goes right, the telescope left";
}

TEST_F(PictureInputTest, EnlargedADragPansAndWithShiftItTurns) {
    view.setZoom(4.0);
    const QPointF before = view.imageFromWidget(QPointF(640, 360));
    drag({640, 360}, {540, 360});
    release({540, 360});
    EXPECT_FALSE(target().has_value());
    EXPECT_NE(view.imageFromWidget(QPointF(640, 360)), before);
    drag({640, 360}, {540, 360}, Qt::ShiftModifier);
    release({540, 360});
    EXPECT_TRUE(target().has_value());
}

TEST_F(PictureInputTest, EscapePutsAToolAwayAndForgetsTheDrag) {
    actions.drag_turns->setChecked(true);
    drag({300, 500}, {500, 500});
    actions.stop->trigger();
    EXPECT_FALSE(actions.drag_turns->isChecked());
    EXPECT_FALSE(view.toolOverlay().drag.has_value());
    release({500, 500});
    EXPECT_FALSE(target().has_value());
}

TEST_F(PictureInputTest, ZoomBoxIsDraggedOnceAndAsksForThatPart) {
    QSignalSpy asked(&bench->routines, &app::ImageRoutines::zoomBoxAsked);
    actions.zoom_box->setChecked(true);
    drag({100, 100}, {260, 190});
    EXPECT_EQ(view.toolOverlay().box, QRectF(100, 100, 160, 90));
    release({260, 190});
    ASSERT_EQ(asked.count(), 1);
    EXPECT_EQ(asked[0][1].toRectF(), QRectF(100, 100, 160, 90));
    EXPECT_EQ(tools.tool(), PictureTools::Tool::kAim);
}

TEST_F(PictureInputTest, MarkToolDrawsAMarkThatCanBeNamedMovedAndDeleted) {
    actions.mark->setChecked(true);
    click({800, 200});
    ASSERT_EQ(bench->marks.marks().size(), 1U);
    const qint64 id = bench->marks.marks()[0].id;
    auto* const name = view.findChild<QLineEdit*>(QStringLiteral("mark_name"));
    ASSERT_TRUE(name != nullptr && name->isVisible());
    name->setText(QStringLiteral("gutter"));
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_EQ(bench->marks.find(id)->label, QStringLiteral("gutter"));
    view.setOverlay({.points = {{.px = {800, 200}, .label = {}, .look = PointLook::kMark, .row_id = id}}});
    const auto before = bench->marks.find(id)->pointing;
    drag({800, 200}, {900, 250});
    release({900, 250});
    EXPECT_NE(bench->marks.find(id)->pointing, before);
    click({800, 200});
    ASSERT_NE(choice(QStringLiteral("Delete")), nullptr);
    QTest::mouseClick(choice(QStringLiteral("Delete")), Qt::LeftButton);
    EXPECT_TRUE(bench->marks.marks().empty());
}

TEST_F(PictureInputTest, EachSnapHasItsShapeAndItsWord) {
    std::vector<QImage> looks;
    QSet<QString> words;
    for (const SnapLook look :
         {SnapLook::kCorner, SnapLook::kCrossing, SnapLook::kCircle, SnapLook::kEllipse}) {
        view.setToolOverlay(
            {.snap = ToolOverlay::Snap{.px = {900, 600}, .look = look, .half_axes_px = {12, 8}}});
        looks.push_back(
            view.grab(QRect(884, 584, 32, 32)).toImage().convertToFormat(QImage::Format_Grayscale8));
        words.insert(snapText(look));
    }
    EXPECT_EQ(words.size(), 4);
    for (std::size_t a = 0; a < looks.size(); ++a) {
        for (std::size_t b = a + 1; b < looks.size(); ++b) {
            EXPECT_NE(looks[a], looks[b]);
        }
    }
}

}  // namespace
}  // namespace pmts::gui
