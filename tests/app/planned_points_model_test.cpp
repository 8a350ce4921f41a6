#include "app/field_fixture.hpp"
#include "pmts/app/field/plan_presenter.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

class PlannedPointsModelTest : public FieldTest {
protected:
    void SetUp() override { openJob(); }

    QString csv(const QByteArray& text) {
        QFile file(folder.filePath(QStringLiteral("design.csv")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return file.fileName();
    }
    bool import(const QByteArray& text) {
        QSignalSpy changed(&planned, &PlannedPointsModel::plannedChanged);
        planned.importFrom(csv(text));
        return until([&] { return !changed.empty(); }, 5s);
    }
    [[nodiscard]] QString text(int row, int column) const {
        return planned.data(planned.index(row, column), Qt::DisplayRole).toString();
    }
    [[nodiscard]] QStringList ids() const {
        QStringList ids;
        for (const auto& point : planned.points()) {
            ids += point.id;
        }
        return ids;
    }
};

const QByteArray kTwo = "P1,1010.5,1020.25,101,AXIS\nP2,1030,1040,102\n";

TEST_F(PlannedPointsModelTest, ImportShowsThePointsInTheUnitsOfTheHeader) {
    QSignalSpy toast(&messages, &MessageCentre::toastShown);
    ASSERT_TRUE(import(kTwo));
    EXPECT_EQ(text(0, PlannedPointsModel::kEasting), QStringLiteral("1010.500"));
    preferences.setUnits(
        {.angle_unit = core::AngleUnit::kGon, .length_unit = core::LengthUnit::kFoot, .length_decimals = 2});
    EXPECT_EQ(text(0, PlannedPointsModel::kEasting), QStringLiteral("3315.29"));
    EXPECT_EQ(planned.headerData(PlannedPointsModel::kEasting, Qt::Horizontal, Qt::DisplayRole).toString(),
              QStringLiteral("E (ft)"));
    EXPECT_THAT(toast.at(0).at(0).value<Message>().happened.toStdString(), testing::HasSubstr("design.csv"));
}

TEST_F(PlannedPointsModelTest, ALineThatCannotBeReadIsSaidAndNothingIsTaken) {
    EXPECT_FALSE(import("P1,1,2,3\nP2,1,zwei,3\n"));
    EXPECT_TRUE(planned.points().empty());
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("Line 2"));
    EXPECT_EQ(undo.count(), 0);
    ASSERT_TRUE(import(kTwo));
    EXPECT_TRUE(messages.bars().empty()) << "solved by an import that worked";
}

TEST_F(PlannedPointsModelTest, AnImportIsUndoneAndRedone) {
    ASSERT_TRUE(import(kTwo));
    undo.undo();
    pass(1s);
    EXPECT_TRUE(planned.points().empty());
    undo.redo();
    pass(1s);
    EXPECT_EQ(ids(), (QStringList{QStringLiteral("P1"), QStringLiteral("P2")}));
}

TEST_F(PlannedPointsModelTest, ARemovedPointComesBackInItsPlaceByUndo) {
    ASSERT_TRUE(import(kTwo));
    const qint64 first = planned.points()[0].row_id;
    planned.remove({first});
    pass(1s);
    EXPECT_EQ(ids(), QStringList{QStringLiteral("P2")});
    EXPECT_EQ(planned.find(first), nullptr);
    undo.undo();
    pass(1s);
    EXPECT_EQ(ids(), (QStringList{QStringLiteral("P1"), QStringLiteral("P2")}));
    EXPECT_EQ(planned.find(first)->code, QStringLiteral("AXIS"));
}

TEST_F(PlannedPointsModelTest, ARemovalTheFileRefusesLeavesPointAndUndoStackAsTheyWere) {
    ASSERT_TRUE(import(kTwo));
    const int steps = undo.count();
    moveJobAway();
    planned.remove({planned.points()[0].row_id});
    pass(1s);
    EXPECT_EQ(planned.points().size(), 2U);
    EXPECT_EQ(undo.count(), steps);
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("moved or deleted"));
}

TEST_F(PlannedPointsModelTest, TheyAreThereAgainWhenTheJobIsOpened) {
    ASSERT_TRUE(import(kTwo));
    job_desk.close();
    ASSERT_TRUE(until([this] { return !job_desk.isOpen(); }));
    EXPECT_TRUE(planned.points().empty());
    job_desk.open(jobPath());
    ASSERT_TRUE(until([this] { return job_desk.isOpen(); }));
    EXPECT_EQ(ids(), (QStringList{QStringLiteral("P1"), QStringLiteral("P2")}));
}

TEST_F(PlannedPointsModelTest, ThePlanDrawsThemApartFromWhatWasMeasured) {
    const PlanPresenter plan(points, planned, station_page, instrument, range);
    QSignalSpy changed(&plan, &PlanPresenter::changed);
    ASSERT_TRUE(import(kTwo));
    EXPECT_GE(changed.count(), 1);
    const PlanScene scene_now = plan.scene();
    EXPECT_TRUE(scene_now.points.empty());
    ASSERT_EQ(scene_now.planned.size(), 2U);
    EXPECT_EQ(scene_now.planned[1].position_en_m, QPointF(1030, 1040));
}

TEST_F(PlannedPointsModelTest, TheTelescopeTurnsToAPlannedPoint) {
    connectInstrument();
    ASSERT_TRUE(import("P1,1010,1010,100\n"));  // north-east of the station, level with it
    targeting.moveToPlanned(planned.points()[0]);
    ASSERT_TRUE(until([this] { return !targeting.isMoving(); }));
    EXPECT_EQ(targeting.target()->state, MoveState::kArrived);
    EXPECT_THAT(targeting.target()->name.toStdString(), testing::HasSubstr("P1"));
    EXPECT_NEAR(targeting.target()->range.slope_distance_m, 14.142, 0.001);
    EXPECT_THAT(true_pointing->at(clock.now()).ha, test::IsNearAngle(Angle::fromGon(50), Angle::fromCc(20)));
}

}  // namespace
}  // namespace pmts::app
