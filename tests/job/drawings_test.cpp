#include "job_support.hpp"

#include <limits>

namespace pmts::job {
namespace {

using core::ErrorKind;
using survey::PlannedPoint;
using test::FailedWith;

PlannedPoint planned(const QString& id, double e_m, double n_m, double h_m) {
    PlannedPoint point;
    point.id = id;
    point.e_m = e_m;
    point.n_m = n_m;
    point.h_m = h_m;
    return point;
}

std::vector<PlannedPoint> corners() {
    PlannedPoint first = planned(QStringLiteral("P1"), 1010.5, 1020.25, 101.125);
    first.code = QStringLiteral("AXIS");
    first.remark = QStringLiteral("Südecke");
    return {first, planned(QStringLiteral("P2"), 1030, 1040, -2)};
}

Photo photoNamed(const QString& name) {
    Photo photo;
    photo.name = name;
    return photo;
}

ImageMark markIn(qint64 photo_row, double x_px, double y_px, const QString& label = {}) {
    return {.photo_row = photo_row, .x_px = x_px, .y_px = y_px, .label = label};
}

TEST_F(JobTest, PlannedPointsAreKeptOverClosing) {
    auto job = created();
    ASSERT_TRUE(job->addPlanned(corners()).has_value());
    job.reset();

    const auto found = *reopened()->planned();

    ASSERT_EQ(found.size(), 2U);
    EXPECT_GT(found[0].row_id, 0);
    EXPECT_EQ(found[0].id, QStringLiteral("P1"));
    EXPECT_EQ(found[0].code, QStringLiteral("AXIS"));
    EXPECT_EQ(found[0].remark, QStringLiteral("Südecke"));
    EXPECT_EQ(found[0].e_m, 1010.5);
    EXPECT_EQ(found[0].n_m, 1020.25);
    EXPECT_EQ(found[0].h_m, 101.125);
    EXPECT_EQ(found[1].h_m, -2.0);
}

TEST_F(JobTest, OtherProgramsSeePlannedPointsAsALayerOfTheirOwnWithExtent) {
    const auto job = created();
    ASSERT_TRUE(job->addPlanned(corners()).has_value());
    const OtherProgram qgis(path);
    OGRLayer& layer = qgis.layer("planned_points");
    EXPECT_EQ(layer.GetGeomType(), wkbPoint25D);
    EXPECT_EQ(layer.GetFeatureCount(), 2);
    EXPECT_EQ(qgis.value("SELECT COUNT(*) FROM gpkg_geometry_columns WHERE srs_id = -1"),
              QStringLiteral("2"));
    EXPECT_EQ(qgis.value("SELECT hex(substr(geom, 5, 4)) FROM planned_points"), QStringLiteral("FFFFFFFF"));
    EXPECT_EQ(qgis.value("SELECT max_x FROM gpkg_contents WHERE table_name = 'planned_points'").toDouble(),
              1030.0);
    EXPECT_EQ(qgis.value("SELECT COUNT(*) FROM rtree_planned_points_geom"), QStringLiteral("2"));
    const OGRFeatureUniquePtr first(layer.GetNextFeature());
    EXPECT_EQ(first->GetGeometryRef()->toPoint()->getZ(), 101.125);
}

TEST_F(JobTest, ARemovedPlannedPointComesBackAsItWas) {
    const auto job = created();
    const auto stored = *job->addPlanned(corners());
    ASSERT_TRUE(job->removePlanned({stored[0].row_id}).has_value());
    ASSERT_EQ(job->planned()->size(), 1U);
    EXPECT_EQ(job->planned()->front().id, QStringLiteral("P2"));

    ASSERT_TRUE(job->addPlanned({stored[0]}).has_value());

    ASSERT_EQ(job->planned()->size(), 2U);
    EXPECT_EQ(job->planned()->front().row_id, stored[0].row_id);
    EXPECT_EQ(job->planned()->front().remark, QStringLiteral("Südecke"));
}

TEST_F(JobTest, OnePlannedPointThatIsNoneKeepsAllOfThemOut) {
    const auto job = created();
    auto points = corners();
    points[1].h_m = std::numeric_limits<double>::infinity();
    EXPECT_THAT(job->addPlanned(points), FailedWith(ErrorKind::kBadInput));
    EXPECT_TRUE(job->planned()->empty());
    const auto stored = *job->addPlanned(corners());
    EXPECT_THAT(job->removePlanned({stored[0].row_id, 4711}), FailedWith(ErrorKind::kBadInput));
    EXPECT_EQ(job->planned()->size(), 2U);
}

TEST_F(JobTest, MarksInAPhotoAreChangedAndRemoved) {
    auto job = created();
    const qint64 north = job->addPhoto(photoNamed(QStringLiteral("north")))->row_id;
    const qint64 south = job->addPhoto(photoNamed(QStringLiteral("south")))->row_id;
    auto crack = *job->addMark(markIn(north, 100.5, 20, QStringLiteral("crack")));
    const auto bolt = *job->addMark(markIn(north, 5, 6, QStringLiteral("bolt")));
    ASSERT_TRUE(job->addMark(markIn(south, 0, 0)).has_value());

    crack.label = QStringLiteral("crack, 2 mm");
    crack.x_px = 101.25;
    ASSERT_TRUE(job->updateMark(crack).has_value());
    ASSERT_TRUE(job->removeMark(bolt.row_id).has_value());
    job.reset();

    const auto found = *reopened()->marksOf(north);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].label, QStringLiteral("crack, 2 mm"));
    EXPECT_EQ(found[0].x_px, 101.25);
    EXPECT_EQ(found[0].y_px, 20.0);
    EXPECT_EQ(found[0].photo_row, north);
}

TEST_F(JobTest, AMarkWithoutItsPhotoIsRefused) {
    const auto job = created();
    EXPECT_THAT(job->addMark(markIn(7, 0, 0)), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(job->updateMark(markIn(1, 0, 0)), FailedWith(ErrorKind::kBadInput));
    EXPECT_THAT(job->removeMark(7), FailedWith(ErrorKind::kBadInput));
}

}  // namespace
}  // namespace pmts::job
