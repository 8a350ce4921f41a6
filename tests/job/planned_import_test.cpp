#include "pmts/job/planned_import.hpp"

#include "job_support.hpp"
#include "pmts/job/export.hpp"

namespace pmts::job {
namespace {

using core::ErrorKind;
using test::FailedWith;

/// Refused as bad input by a sentence that holds these words.
MATCHER_P(RefusedSaying, words, "") {
    if (arg.has_value() || arg.error().kind != ErrorKind::kBadInput) {
        return false;
    }
    *result_listener << arg.error().sentence().toStdString();
    return arg.error().happened.contains(QString::fromUtf8(words)) && !arg.error().remedy.isEmpty();
}

TEST(PlannedImportTest, ReadsIdEastNorthHeightInThisOrder) {
    const auto points =
        plannedFromText("P1,1010.5,1020.25,101\nP2,1030,1040,-2.5,AXIS,\"the \"\"old\"\", grey one\"\n");
    ASSERT_TRUE(points.has_value());
    ASSERT_EQ(points->size(), 2U);
    EXPECT_EQ(points->at(0).id, QStringLiteral("P1"));
    EXPECT_EQ(points->at(0).n_m, 1020.25);
    EXPECT_EQ(points->at(1).h_m, -2.5);
    EXPECT_EQ(points->at(1).code, QStringLiteral("AXIS"));
    EXPECT_EQ(points->at(1).remark, QStringLiteral("the \"old\", grey one"));
}

TEST(PlannedImportTest, AFirstLineOfNamesGivesTheOrder) {
    const auto points =
        plannedFromText("\xEF\xBB\xBFNorthing;Easting;Height;Code;Point\r\n1020,25;1010,5;101;AXIS;P1\r\n");
    ASSERT_TRUE(points.has_value());
    EXPECT_EQ(points->front().id, QStringLiteral("P1"));
    EXPECT_EQ(points->front().e_m, 1010.5);
    EXPECT_EQ(points->front().n_m, 1020.25);
    EXPECT_EQ(points->front().code, QStringLiteral("AXIS"));
}

TEST(PlannedImportTest, TabsLatin1EmptyLinesAndRemarksAreUnderstood) {
    const auto points = plannedFromText(
        "# made by hand\n\nS\xFC"
        "d\t1\t2\t3\n\n");
    ASSERT_TRUE(points.has_value());
    EXPECT_EQ(points->front().id, QStringLiteral("Süd"));
    EXPECT_EQ(points->front().h_m, 3.0);
}

TEST(PlannedImportTest, ALineThatCannotBeReadIsNamed) {
    EXPECT_THAT(plannedFromText("P1,1,2,3\nP2,1,zwei,3\n"), RefusedSaying("Line 2"));
    EXPECT_THAT(plannedFromText("P1,1,2,3\nP2,1,zwei,3\n"), RefusedSaying("“zwei” is no number for N"));
    EXPECT_THAT(plannedFromText("P1,1,2,3\n\nP2,1,2\n"),
                RefusedSaying("Line 3 of the planned points: H is missing"));
    EXPECT_THAT(plannedFromText("id,e,n,h\n,1,2,3\n"),
                RefusedSaying("Line 2 of the planned points: the point has no ID"));
    EXPECT_THAT(plannedFromText("P1,\"1\n\",2,3\nP2,nan,2,3"), RefusedSaying("Line 3"));
}

TEST(PlannedImportTest, XAndYAreRefusedBecauseNobodyKnowsWhichIsEast) {
    EXPECT_THAT(plannedFromText("id,x,y,z\nP1,1,2,3\n"), RefusedSaying("no column is called “e”"));
}

TEST(PlannedImportTest, AFileWithoutPointsIsRefused) {
    EXPECT_THAT(plannedFromText(""), RefusedSaying("no planned point"));
    EXPECT_THAT(plannedFromText("id,e,n,h\n"), RefusedSaying("no planned point"));
    EXPECT_THAT(plannedFromFile(QStringLiteral("/nowhere/points.csv")), FailedWith(ErrorKind::kFile));
}

TEST_F(JobTest, PointsExportedByPmtsComeInAsPlannedPoints) {
    survey::Point absurd = shotPoint(2);
    absurd.observation.slope_distance_m.reset();
    absurd.observation.absurd_reason = QStringLiteral("no echo");
    const QString csv = folder.filePath(QStringLiteral("points.csv"));
    ASSERT_TRUE(exportPoints({shotPoint(1), absurd}, csv, ExportFormat::kCsv).has_value());

    const auto points = plannedFromFile(csv);

    ASSERT_TRUE(points.has_value()) << points.error().sentence().toStdString();
    ASSERT_EQ(points->size(), 1U);
    EXPECT_EQ(points->front().id, shotPoint(1).id);
    EXPECT_EQ(points->front().code, shotPoint(1).code);
    EXPECT_EQ(points->front().remark, shotPoint(1).remark);
    EXPECT_NEAR(points->front().e_m, shotPoint(1).coordinates.e_m, 5e-5);
    EXPECT_NEAR(points->front().h_m, shotPoint(1).coordinates.h_m, 5e-5);
}

}  // namespace
}  // namespace pmts::job
