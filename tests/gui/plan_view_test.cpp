#include "field/plan_view.hpp"

#include <QSignalSpy>
#include <QTest>
#include <gmock/gmock.h>

namespace pmts::gui {
namespace {

app::PlanScene sceneWithTwoPoints() {
    app::PlanScene scene;
    scene.station_en_m = {1000, 1000};
    scene.station_name = QStringLiteral("100");
    scene.points = {{.position_en_m = {1010, 1000}, .id = QStringLiteral("1"), .code = {}, .row_id = 11},
                    {.position_en_m = {1000, 1010}, .id = QStringLiteral("2"), .code = {}, .row_id = 12}};
    return scene;
}

class PlanViewTest : public testing::Test {
protected:
    PlanViewTest() {
        plan.resize(400, 300);
        plan.showScene(sceneWithTwoPoints());
        plan.show();
    }

    [[nodiscard]] QPoint placeOf(double e_m, double n_m) const {
        return plan.widgetFromGround({e_m, n_m}).toPoint();
    }

    PlanView plan;
};

TEST_F(PlanViewTest, EastIsRightAndNorthIsUp) {
    EXPECT_GT(placeOf(1010, 1000).x(), placeOf(1000, 1000).x());
    EXPECT_LT(placeOf(1000, 1010).y(), placeOf(1000, 1000).y());
}

TEST_F(PlanViewTest, FitsEverythingInside) {
    for (const QPointF& en_m : {QPointF(1000, 1000), QPointF(1010, 1000), QPointF(1000, 1010)}) {
        EXPECT_TRUE(plan.rect().contains(plan.widgetFromGround(en_m).toPoint()));
    }
}

TEST_F(PlanViewTest, ClickSelectsTheNearestPoint) {
    QSignalSpy clicked(&plan, &PlanView::pointClicked);
    QTest::mouseClick(&plan, Qt::LeftButton, {}, placeOf(1010, 1000) + QPoint(4, -3));
    ASSERT_EQ(clicked.count(), 1);
    EXPECT_EQ(clicked.takeFirst().at(0).toLongLong(), 11);
    EXPECT_EQ(plan.selectedPoint(), 11);
}

TEST_F(PlanViewTest, DoubleClickAsksToTurn) {
    QSignalSpy turn(&plan, &PlanView::pointDoubleClicked);
    QTest::mouseDClick(&plan, Qt::LeftButton, {}, placeOf(1000, 1010));
    ASSERT_EQ(turn.count(), 1);
    EXPECT_EQ(turn.takeFirst().at(0).toLongLong(), 12);
}

TEST_F(PlanViewTest, PlannedPointsAreToldApartFromMeasuredOnes) {
    app::PlanScene scene = sceneWithTwoPoints();
    scene.planned = {{.position_en_m = {1010, 1010}, .id = QStringLiteral("P1"), .code = {}, .row_id = 11}};
    plan.showScene(scene);
    QSignalSpy measured(&plan, &PlanView::pointDoubleClicked);
    QSignalSpy planned(&plan, &PlanView::plannedDoubleClicked);
    QTest::mouseDClick(&plan, Qt::LeftButton, {}, placeOf(1010, 1010));
    EXPECT_EQ(measured.count(), 0);
    ASSERT_EQ(planned.count(), 1);
    EXPECT_EQ(planned.takeFirst().at(0).toLongLong(), 11);
}

TEST_F(PlanViewTest, ClickOnNothingSelectsNothing) {
    QSignalSpy clicked(&plan, &PlanView::pointClicked);
    QTest::mouseClick(&plan, Qt::LeftButton, {}, QPoint(2, 2));
    EXPECT_EQ(clicked.count(), 0);
}

TEST_F(PlanViewTest, StaysWhereSomebodyPannedWhenPointsArrive) {
    plan.zoomBy(2.0);
    const QPointF before = plan.groundFromWidget({0, 0});
    app::PlanScene more = sceneWithTwoPoints();
    more.points.push_back(
        {.position_en_m = {1100, 1100}, .id = QStringLiteral("3"), .code = {}, .row_id = 13});
    plan.showScene(more);
    EXPECT_EQ(plan.groundFromWidget({0, 0}), before);
}

TEST(NiceLength, IsOneTwoOrFive) {
    EXPECT_DOUBLE_EQ(niceLength(0.7), 0.5);
    EXPECT_DOUBLE_EQ(niceLength(1.99), 1.0);
    EXPECT_DOUBLE_EQ(niceLength(49.0), 20.0);
    EXPECT_DOUBLE_EQ(niceLength(500.0), 500.0);
}

}  // namespace
}  // namespace pmts::gui
