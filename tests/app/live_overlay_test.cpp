#include "app/field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

class LiveOverlayTest : public FieldTest {
protected:
    void SetUp() override {
        connectInstrument();
        showFrames();
    }
    /// The station stands at its default, 1000/1000/100, oriented to grid north.
    void plan(const char* label, double n_m, qint64 row_id = 1) {
        planned_points.push_back({.row_id = row_id, .id = QString::fromLatin1(label), .code = {}, .remark = {},
                                  .e_m = 1000.1, .n_m = 1000 + n_m, .h_m = 100});
        live.setPlannedPoints(planned_points);
    }
    void setDepth(std::optional<double> near_m, std::optional<double> far_m) {
        Settings next = preferences.settings();
        next.image_tools.depth = {.near_m = near_m, .far_m = far_m};
        preferences.set(next);
    }
    [[nodiscard]] QStringList labels() const {
        QStringList drawn;
        for (const OverlayItem& item : live.scene().overlay) {
            drawn.append(item.label);
        }
        return drawn;
    }

    std::vector<survey::PlannedPoint> planned_points;
};

TEST_F(LiveOverlayTest, PlannedPointIsDrawnAtItsTruePlaceWithItsOwnKind) {
    plan("P1", 20);
    ASSERT_EQ(live.scene().overlay.size(), 1U);
    const OverlayItem& item = live.scene().overlay[0];
    EXPECT_EQ(item.kind, OverlayKind::kPlanned);
    EXPECT_EQ(item.row_id, 1);
    const QPointF expected = pixelOf({0.1, 20, 0});
    EXPECT_NEAR(item.px.x(), expected.x(), 1e-6);
    EXPECT_NEAR(item.px.y(), expected.y(), 1e-6);
}

TEST_F(LiveOverlayTest, OnlyPointsBetweenNearAndFarAreDrawn) {
    plan("close", 5, 1);
    plan("wall", 15, 2);
    plan("tower", 300, 3);
    EXPECT_EQ(labels().size(), 3);
    setDepth(10.0, 100.0);
    EXPECT_EQ(labels(), QStringList{QStringLiteral("wall")});
    setDepth(10.0, std::nullopt);
    EXPECT_EQ(labels(), (QStringList{QStringLiteral("wall"), QStringLiteral("tower")}));
}

TEST_F(LiveOverlayTest, TargetIsDrawnWhateverNearAndFarSay) {
    setDepth(100.0, 200.0);
    targeting.aimAtLivePixel({600, 300});
    ASSERT_EQ(live.scene().overlay.size(), 1U);
    EXPECT_EQ(live.scene().overlay[0].kind, OverlayKind::kTarget);
}

TEST_F(LiveOverlayTest, StillHearsOfEverythingThatIsDrawnOverIt) {
    QSignalSpy places(&live, &LivePresenter::placesChanged);
    plan("P1", 20);
    setDepth(1.0, 50.0);
    range.addShot({.ha = Angle::fromGon(1), .va = Angle::fromGon(100)}, 15.0);
    targeting.aimAtLivePixel({600, 300});
    EXPECT_GE(places.size(), 4);
    const auto before = places.size();
    showFrames(2);
    EXPECT_EQ(places.size(), before) << "a still does not change with every frame of the live view";
}

TEST_F(LiveOverlayTest, ParallaxCurvePassesThroughTheReticle) {
    const LiveScene& shown = live.scene();
    ASSERT_TRUE(shown.reticle_px.has_value());
    ASSERT_EQ(shown.parallax.marks.size(), 3U);
    EXPECT_EQ(shown.parallax.marks[2].kind, ParallaxCurve::MarkKind::kInUse);
    EXPECT_EQ(shown.parallax.marks[2].px, *shown.reticle_px);
}

TEST_F(LiveOverlayTest, DraggedSpotEndsWhereItWasReleased) {
    const QPointF grabbed(500, 250), released(700, 400);
    const auto spot = live.model().pointingForPixel({500, 250}, *live.scene().pointing, 25.0);
    targeting.bringToPixel(grabbed, released);
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    EXPECT_EQ(targeting.target()->state, MoveState::kArrived);
    showFrames();
    const QPointF seen = pixelOf(geometry::stationFromPolar({*spot, 25.0}));
    EXPECT_NEAR(seen.x(), released.x(), 0.2);  // 5 cc of tolerance are less than 0.1 px
    EXPECT_NEAR(seen.y(), released.y(), 0.2);
}

}  // namespace
}  // namespace pmts::app
