#include "app/field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

class PointsModelTest : public FieldTest {
protected:
    void SetUp() override { openJob(); }

    static survey::Point shot(const QString& id, double distance_m) {
        survey::Point point;
        point.id = id;
        point.code = QStringLiteral("WALL");
        point.station_name = QStringLiteral("100");
        point.observation.pointing = {.ha = Angle::fromGon(100), .va = Angle::fromGon(100)};  // due east, level
        point.observation.slope_distance_m = distance_m;
        point.coordinates = {.e_m = 1000 + distance_m, .n_m = 1000, .h_m = 100, .sigma_e_m = 0.003, .sigma_n_m = 0.002,
                             .sigma_h_m = 0.001};
        return point;
    }
    void record(const QString& id, double distance_m = 10) {
        QSignalSpy recorded(&job_desk, &JobDesk::recorded);
        job_desk.record(shot(id, distance_m));
        ASSERT_TRUE(until([&] { return !recorded.empty(); }));
        points.addRecorded(recorded.at(0).at(1).value<survey::Point>());
    }
    [[nodiscard]] QString text(int row, int column) const {
        return points.data(points.index(row, column), Qt::DisplayRole).toString();
    }
    [[nodiscard]] std::vector<survey::Point> inTheFile() {
        job_desk.close();
        (void)until([this] { return !job_desk.isOpen(); });
        const auto job = job::Job::open(folder.filePath(QStringLiteral("wall.gpkg")));
        return (*job)->points().value();
    }
};

TEST_F(PointsModelTest, TableShowsNumbersInTheUnitsOfTheHeader) {
    record(QStringLiteral("1"), 3.048);
    preferences.setUnits({.angle_unit = core::AngleUnit::kDegree, .length_unit = core::LengthUnit::kFoot, .length_decimals = 2});
    EXPECT_EQ(text(0, PointsModel::kSd), QStringLiteral("10.00"));
    EXPECT_EQ(text(0, PointsModel::kHa), QStringLiteral("90.0000"));
    EXPECT_EQ(points.headerData(PointsModel::kSd, Qt::Horizontal, Qt::DisplayRole).toString(), QStringLiteral("SD (ft)"));
}

TEST_F(PointsModelTest, SortRoleSortsNumbersAsNumbers) {
    record(QStringLiteral("1"), 9);
    record(QStringLiteral("2"), 10);
    const auto nine = points.data(points.index(0, PointsModel::kEasting), PointsModel::kSortRole);
    const auto ten = points.data(points.index(1, PointsModel::kEasting), PointsModel::kSortRole);
    EXPECT_LT(nine.toDouble(), ten.toDouble());
}

TEST_F(PointsModelTest, EditingTheIdIsOneUndoStepAndReachesTheFile) {
    record(QStringLiteral("1"));
    ASSERT_TRUE(points.setData(points.index(0, PointsModel::kId), QStringLiteral("A7"), Qt::EditRole));
    EXPECT_EQ(text(0, PointsModel::kId), QStringLiteral("A7"));
    undo.undo();
    EXPECT_EQ(text(0, PointsModel::kId), QStringLiteral("1"));
    undo.redo();
    EXPECT_EQ(inTheFile().at(0).id, QStringLiteral("A7"));
}

TEST_F(PointsModelTest, OnlyIdCodeAndRemarkAreEditable) {
    record(QStringLiteral("1"));
    for (int column = 0; column < PointsModel::kColumnCount; ++column) {
        const bool editable = points.flags(points.index(0, column)) & Qt::ItemIsEditable;
        EXPECT_EQ(editable, column == PointsModel::kId || column == PointsModel::kCode || column == PointsModel::kRemark);
    }
    EXPECT_FALSE(points.setData(points.index(0, PointsModel::kSd), QStringLiteral("1"), Qt::EditRole));
}

TEST_F(PointsModelTest, EmptyIdIsRefusedWithAMessage) {
    record(QStringLiteral("1"));
    points.edit(points.points()[0].row_id, QStringLiteral("  "), {}, {});
    EXPECT_EQ(text(0, PointsModel::kId), QStringLiteral("1"));
    EXPECT_EQ(messages.bars().size(), 1U);
}

TEST_F(PointsModelTest, UndoingARecordStrikesItOutAndKeepsTheRawData) {
    record(QStringLiteral("1"));
    undo.undo();
    EXPECT_TRUE(points.data(points.index(0, 0), PointsModel::kStruckOutRole).toBool());
    const auto kept = inTheFile();
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_TRUE(kept[0].struck_out);
    EXPECT_EQ(kept[0].observation.slope_distance_m, 10.0);
}

TEST_F(PointsModelTest, RedoBringsAStruckOutRecordBack) {
    record(QStringLiteral("1"));
    undo.undo();
    undo.redo();
    EXPECT_FALSE(points.points()[0].struck_out);
}

TEST_F(PointsModelTest, StrikingOutSeveralIsOneStep) {
    record(QStringLiteral("1"));
    record(QStringLiteral("2"));
    const int steps = undo.count();
    points.strikeOut({points.points()[0].row_id, points.points()[1].row_id});
    EXPECT_EQ(undo.count(), steps + 1);
    EXPECT_TRUE(points.points()[0].struck_out && points.points()[1].struck_out);
    undo.undo();
    EXPECT_FALSE(points.points()[0].struck_out || points.points()[1].struck_out);
}

TEST_F(PointsModelTest, DuplicateFlagGoesWhenOneOfTheTwoIsStruckOut) {
    record(QStringLiteral("1"));
    record(QStringLiteral("1"));
    EXPECT_TRUE(points.data(points.index(0, 0), PointsModel::kDuplicateRole).toBool());
    points.strikeOut({points.points()[0].row_id});
    EXPECT_FALSE(points.data(points.index(1, 0), PointsModel::kDuplicateRole).toBool());
    EXPECT_EQ(points.findId(QStringLiteral("1"))->row_id, points.points()[1].row_id);
}

TEST_F(PointsModelTest, ChangeTheFileRefusesIsTakenBackWithItsUndoStepAndAMessage) {
    record(QStringLiteral("1"));
    const int steps = undo.count();
    moveJobAway();
    points.edit(points.points()[0].row_id, QStringLiteral("A7"), {}, {});
    EXPECT_EQ(text(0, PointsModel::kId), QStringLiteral("A7")) << "shown at once";
    pass(1s);
    EXPECT_EQ(text(0, PointsModel::kId), QStringLiteral("1"));
    EXPECT_EQ(undo.count(), steps);
    EXPECT_EQ(undo.undoText(), QStringLiteral("Record 1"));
    EXPECT_THAT(newestBar(messages).toStdString(), testing::HasSubstr("moved or deleted"));
}

TEST_F(PointsModelTest, TwoRefusedChangesOfOnePointLeaveWhatTheFileHolds) {
    record(QStringLiteral("1"));
    const int steps = undo.count();
    moveJobAway();
    points.edit(points.points()[0].row_id, QStringLiteral("A7"), {}, {});
    points.edit(points.points()[0].row_id, QStringLiteral("A8"), {}, {});
    pass(1s);
    EXPECT_EQ(text(0, PointsModel::kId), QStringLiteral("1"));
    EXPECT_EQ(undo.count(), steps);
}

TEST_F(PointsModelTest, UndoTheFileRefusesCanBeUndoneAgainLater) {
    record(QStringLiteral("1"));
    points.edit(points.points()[0].row_id, QStringLiteral("A7"), {}, {});
    pass(1s);
    moveJobAway();
    undo.undo();
    pass(1s);
    ASSERT_EQ(text(0, PointsModel::kId), QStringLiteral("A7"));
    ASSERT_EQ(undo.undoText(), QStringLiteral("Edit A7"));
    bringJobBack();
    undo.undo();
    EXPECT_EQ(inTheFile().at(0).id, QStringLiteral("1"));
}

TEST_F(PointsModelTest, CodesComeMostUsedFirst) {
    record(QStringLiteral("1"));
    record(QStringLiteral("2"));
    record(QStringLiteral("3"));
    points.edit(points.points()[0].row_id, QStringLiteral("1"), QStringLiteral("TREE"), {});
    EXPECT_EQ(points.codes(), (QStringList{QStringLiteral("WALL"), QStringLiteral("TREE")}));
}

TEST_F(PointsModelTest, ClosingTheJobEmptiesTableAndUndoStack) {
    record(QStringLiteral("1"));
    job_desk.close();
    ASSERT_TRUE(until([this] { return !job_desk.isOpen(); }));
    EXPECT_EQ(points.rowCount(), 0);
    EXPECT_EQ(undo.count(), 0);
}

}  // namespace
}  // namespace pmts::app
