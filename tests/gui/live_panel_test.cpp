#include "field/live_panel.hpp"

#include "bench_fixture.hpp"
#include "picture_source.hpp"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

namespace pmts::gui {
namespace {

using app::MoveState;
using app::OverlayItem;
using app::OverlayKind;

OverlayItem targetIn(MoveState state) {
    return {
        .kind = OverlayKind::kTarget, .px = {100, 50}, .label = {}, .code = {}, .row_id = 0, .move = state};
}

TEST(OverlayOf, KeepsPlacesLabelsAndTheSelectedPoint) {
    const OverlayItem point{.kind = OverlayKind::kPoint,
                            .px = {12.5, 7.25},
                            .label = QStringLiteral("104"),
                            .code = {},
                            .row_id = 11};
    const ImageOverlay overlay = overlayOf({point}, QPointF(640, 360), 11, {});
    ASSERT_EQ(overlay.points.size(), 1U);
    EXPECT_EQ(overlay.points[0].px, QPointF(12.5, 7.25));
    EXPECT_EQ(overlay.points[0].label, QStringLiteral("104"));
    EXPECT_TRUE(overlay.points[0].selected);
    EXPECT_EQ(overlay.reticle, QPointF(640, 360));
}

TEST(OverlayOf, EachStateOfAMoveHasItsLook) {
    const std::pair<MoveState, TargetLook> looks[] = {{MoveState::kAimed, TargetLook::kClicked},
                                                      {MoveState::kQueued, TargetLook::kQueued},
                                                      {MoveState::kTurning, TargetLook::kTurning},
                                                      {MoveState::kRecentring, TargetLook::kRecentring},
                                                      {MoveState::kArrived, TargetLook::kArrived},
                                                      {MoveState::kLost, TargetLook::kLost}};
    for (const auto& [state, look] : looks) {
        EXPECT_EQ(overlayOf({targetIn(state)}, {}, 0, {}).target->look, look);
    }
}

TEST(OverlayOf, NoTargetIsDrawnWhenThereIsNone) {
    EXPECT_FALSE(overlayOf({targetIn(MoveState::kNone)}, {}, 0, {}).target);
}

class LivePanelTest : public test::WindowFixture {
protected:
    LivePanelTest() : panel(bench->live, bench->targeting) {
        panel.resize(800, 500);
        panel.show();
    }

    LivePanel panel;
};

TEST_F(LivePanelTest, ReticleMakesWayForWhatLiesUnderIt) {
    bench->live.setSource(std::make_unique<test::PictureSource>());
    ASSERT_TRUE(panel.view().overlay().reticle.has_value());

    panel.setReticleShown(false);
    EXPECT_FALSE(panel.view().overlay().reticle.has_value());
    EXPECT_TRUE(panel.view().overlay().parallax.empty());

    panel.setReticleShown(true);
    EXPECT_TRUE(panel.view().overlay().reticle.has_value());
}

TEST_F(LivePanelTest, WithoutACameraItSaysWhy) {
    const QImage picture = panel.view().grab().toImage();
    bool has_plate = false;
    for (int x = 0; x < picture.width() && !has_plate; ++x) {
        has_plate = picture.pixelColor(x, panel.view().height() / 2).lightness() > 200;
    }
    EXPECT_TRUE(has_plate);
}

TEST_F(LivePanelTest, ProgressHasACancelThatCancels) {
    QSignalSpy cancelled(&panel, &LivePanel::cancelRequested);
    panel.showBusy(true, QStringLiteral("Measuring, usually 5 s"), 0.3);
    auto* const cancel = panel.findChild<QPushButton*>(QStringLiteral("cancel"));
    ASSERT_TRUE(cancel->isVisible());
    QTest::mouseClick(cancel, Qt::LeftButton);
    EXPECT_EQ(cancelled.count(), 1);
    panel.showBusy(false, {}, 0.0);
    EXPECT_FALSE(cancel->isVisible());
}

TEST_F(LivePanelTest, GoodNewsIsAToast) {
    panel.showToast(QStringLiteral("Point 104 is recorded."));
    bool shown = false;
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        shown = shown || (label->isVisible() && label->text() == QStringLiteral("Point 104 is recorded."));
    }
    EXPECT_TRUE(shown);
}

}  // namespace
}  // namespace pmts::gui
