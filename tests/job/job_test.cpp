#include "job_support.hpp"

#include <QDir>
#include <QFile>

#include <limits>

namespace pmts::job {
namespace {

using core::Angle;
using core::ErrorKind;
using test::FailedWith;

TEST_F(JobTest, KeepsEveryValueOfAPointOverClosing) {
    auto job = created();
    const auto recorded = job->record(shotPoint(7));
    ASSERT_TRUE(recorded.has_value());
    EXPECT_GT(recorded->row_id, 0);
    job.reset();

    const auto points = reopened()->points();

    ASSERT_TRUE(points.has_value());
    ASSERT_EQ(points->size(), 1U);
    const survey::Point& found = points->front();
    const survey::Point expected = shotPoint(7);
    EXPECT_EQ(found.row_id, recorded->row_id);
    EXPECT_EQ(found.id, expected.id);
    EXPECT_EQ(found.code, expected.code);
    EXPECT_EQ(found.remark, expected.remark);
    EXPECT_EQ(found.station_name, expected.station_name);
    EXPECT_EQ(found.coordinates.e_m, expected.coordinates.e_m);
    EXPECT_EQ(found.coordinates.n_m, expected.coordinates.n_m);
    EXPECT_EQ(found.coordinates.h_m, expected.coordinates.h_m);
    EXPECT_EQ(found.coordinates.sigma_h_m, expected.coordinates.sigma_h_m);
    EXPECT_EQ(found.observation.pointing, expected.observation.pointing);
    EXPECT_EQ(found.observation.slope_distance_m, expected.observation.slope_distance_m);
    EXPECT_EQ(found.observation.target_height_m, expected.observation.target_height_m);
    EXPECT_EQ(found.observation.edm_mode, expected.observation.edm_mode);
    EXPECT_EQ(found.observation.time_taken_s, expected.observation.time_taken_s);
    EXPECT_EQ(found.observation.utc, expected.observation.utc);
    EXPECT_EQ(found.observation.raw_reply, expected.observation.raw_reply);
    EXPECT_EQ(found.observation.source, expected.observation.source);
    EXPECT_FALSE(found.struck_out);
}

TEST_F(JobTest, AnAbsurdPointHasNoPlaceAndKeepsItsReason) {
    auto job = created();
    survey::Point absurd = shotPoint(1);
    absurd.observation.slope_distance_m.reset();
    absurd.observation.absurd_reason = QStringLiteral("no echo within 7 s");
    ASSERT_TRUE(job->record(absurd).has_value());
    job.reset();

    const auto points = reopened()->points();

    ASSERT_EQ(points->size(), 1U);
    EXPECT_FALSE(points->front().hasCoordinates());
    EXPECT_EQ(points->front().observation.absurd_reason, absurd.observation.absurd_reason);
    const OtherProgram qgis(path);
    EXPECT_EQ(qgis.value("SELECT geom IS NULL FROM points"), QStringLiteral("1"));
    EXPECT_EQ(qgis.value("SELECT sd_m IS NULL FROM observations"), QStringLiteral("1"));
}

TEST_F(JobTest, RefusesValuesThatAreNotNumbers) {
    const auto job = created();
    survey::Point broken = shotPoint(1);
    broken.coordinates.h_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(job->record(broken), FailedWith(ErrorKind::kUndefined));
    EXPECT_TRUE(job->points()->empty());
}

TEST_F(JobTest, EditingAPointLeavesItsObservationAlone) {
    const auto job = created();
    survey::Point point = *job->record(shotPoint(1));
    point.id = QStringLiteral("B1");
    point.code = QStringLiteral("ROOF");
    point.remark.clear();
    point.struck_out = true;
    point.observation.slope_distance_m = 99.0;  // not the caller's to change

    ASSERT_TRUE(job->update(point).has_value());

    const survey::Point found = job->points()->front();
    EXPECT_EQ(found.id, QStringLiteral("B1"));
    EXPECT_EQ(found.code, QStringLiteral("ROOF"));
    EXPECT_EQ(found.remark, QString());
    EXPECT_TRUE(found.struck_out);
    EXPECT_EQ(found.observation.slope_distance_m, shotPoint(1).observation.slope_distance_m);
    EXPECT_EQ(found.coordinates.e_m, shotPoint(1).coordinates.e_m);
}

TEST_F(JobTest, EditingAnUnknownPointIsRefused) {
    survey::Point stranger = shotPoint(1);
    stranger.row_id = 4711;
    EXPECT_THAT(created()->update(stranger), FailedWith(ErrorKind::kBadInput));
}

TEST_F(JobTest, NewCoordinatesAreWrittenTogetherAndNothingElseChanges) {
    auto job = created();
    std::vector<survey::Point> points;
    for (int i = 0; i < 50; ++i) {
        points.push_back(*job->record(shotPoint(i)));
        points.back().coordinates.e_m += 1000.0;
        points.back().coordinates.sigma_e_m = 0.009;
        points.back().id = QStringLiteral("not to be written");
    }

    ASSERT_TRUE(job->updateCoordinates(points).has_value());
    job.reset();

    const auto found = *reopened()->points();
    EXPECT_EQ(found[49].coordinates.e_m, 3049.5);
    EXPECT_EQ(found[0].coordinates.sigma_e_m, 0.009);
    EXPECT_EQ(found[0].id, QStringLiteral("A000"));
    const OtherProgram qgis(path);
    EXPECT_EQ(qgis.value("SELECT MAX(maxx) > 3049 FROM rtree_points_geom"), QStringLiteral("1"));
}

TEST_F(JobTest, OneUnknownPointLeavesAllCoordinatesAsTheyWere) {
    const auto job = created();
    std::vector<survey::Point> points{*job->record(shotPoint(0)), shotPoint(1)};
    points[0].coordinates.e_m = 1.0;
    EXPECT_THAT(job->updateCoordinates(points), FailedWith(ErrorKind::kBadInput));
    EXPECT_EQ(job->points()->front().coordinates.e_m, shotPoint(0).coordinates.e_m);
}

TEST_F(JobTest, EveryChangeOfAStationIsKeptAndTheLastIsCurrent) {
    auto job = created();
    EXPECT_EQ(job->station()->name, QStringLiteral("100"));  // the default, nothing recorded yet
    survey::Station station{
        .name = QStringLiteral("S1"), .e_m = 2000, .n_m = 1000, .h_m = 50, .instrument_height_m = 1.5};
    ASSERT_TRUE(job->setStation(station).has_value());
    station.orientation = Angle::fromGon(50);
    ASSERT_TRUE(job->setStation(station).has_value());
    job.reset();

    job = reopened();
    ASSERT_EQ(job->stations()->size(), 2U);
    EXPECT_EQ(job->stations()->front().orientation, Angle::fromGon(0));
    EXPECT_EQ(job->station()->orientation, Angle::fromGon(50));
    EXPECT_EQ(job->station()->instrument_height_m, 1.5);
}

TEST_F(JobTest, AnObservationKnowsTheSetUpItWasMadeFrom) {
    auto job = created();
    ASSERT_TRUE(job->record(shotPoint(0)).has_value());
    ASSERT_TRUE(job->setStation({}).has_value());
    ASSERT_TRUE(job->setStation({}).has_value());
    ASSERT_TRUE(job->record(shotPoint(1)).has_value());
    job.reset();
    const OtherProgram qgis(path);
    EXPECT_EQ(qgis.value("SELECT station_row IS NULL FROM observations WHERE fid = 1"), QStringLiteral("1"));
    EXPECT_EQ(qgis.value("SELECT station_row FROM observations WHERE fid = 2"), QStringLiteral("2"));
}

TEST_F(JobTest, APhotoIsKeptByteForByteAndListedWithoutItsBytes) {
    auto job = created();
    QByteArray bytes;
    for (unsigned i = 0; i < 300000; ++i) {
        bytes.append(static_cast<char>(i * 7919 >> 3));
    }
    const Photo photo{.name = QStringLiteral("north"),
                      .encoded_image = bytes,
                      .pointing = {.ha = Angle::fromGon(199.3587), .va = Angle::fromGon(105.9808)},
                      .station_name = QStringLiteral("100"),
                      .utc = shotPoint(0).observation.utc,
                      .rig_json = QStringLiteral("{\"mount\":\"handle\"}")};
    const auto added = job->addPhoto(photo);
    ASSERT_TRUE(added.has_value());
    job.reset();

    job = reopened();
    const auto photos = *job->photos();
    ASSERT_EQ(photos.size(), 1U);
    EXPECT_TRUE(photos[0].encoded_image.isEmpty());
    EXPECT_EQ(photos[0].pointing, photo.pointing);
    EXPECT_EQ(photos[0].rig_json, photo.rig_json);
    EXPECT_EQ(photos[0].utc, photo.utc);
    EXPECT_EQ(*job->photoImage(added->row_id), bytes);
    EXPECT_THAT(job->photoImage(99), FailedWith(ErrorKind::kBadInput));
}

TEST_F(JobTest, TheLogGivesItsNewestEntriesInOrder) {
    const auto job = created();
    EXPECT_TRUE(job->logEntries(3)->empty());
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(job->log({shotPoint(0).observation.utc.addSecs(i), QStringLiteral("instrument"),
                              QStringLiteral("entry %1").arg(i)})
                        .has_value());
    }
    const auto entries = *job->logEntries(3);
    ASSERT_EQ(entries.size(), 3U);
    EXPECT_EQ(entries[0].text, QStringLiteral("entry 7"));
    EXPECT_EQ(entries[2].text, QStringLiteral("entry 9"));
    EXPECT_EQ(job->logEntries(100)->size(), 10U);
}

TEST_F(JobTest, RemembersSmallTexts) {
    auto job = created();
    EXPECT_EQ(*job->meta(QStringLiteral("next_point_id")), QString());
    ASSERT_TRUE(job->setMeta(QStringLiteral("next_point_id"), QStringLiteral("A09")).has_value());
    ASSERT_TRUE(job->setMeta(QStringLiteral("next_point_id"), QStringLiteral("it's A10")).has_value());
    EXPECT_THROW((void)job->setMeta(QStringLiteral("schema_version"), QStringLiteral("9")), std::logic_error);
    job.reset();
    EXPECT_EQ(*reopened()->meta(QStringLiteral("next_point_id")), QStringLiteral("it's A10"));
}

TEST_F(JobTest, RawDataCannotBeChangedByAnyProgram) {
    createWith(2);
    const OtherProgram editor(path, GDAL_OF_UPDATE);
    for (const char* sql : {"UPDATE observations SET sd_m = 1", "DELETE FROM observations WHERE fid = 1",
                            "INSERT OR REPLACE INTO observations (fid, sd_m) VALUES (1, 3.0)"}) {
        EXPECT_TRUE(editor.refusal(sql).contains(QStringLiteral("never changed"))) << sql;
    }
    EXPECT_TRUE(editor.refusal("DELETE FROM points").contains(QStringLiteral("struck out")));
    EXPECT_EQ(editor.value("SELECT SUM(sd_m) FROM observations").toDouble(), 51.246);
}

TEST_F(JobTest, ANameThatIsInjectedSqlIsOnlyAName) {
    const auto job = created();
    survey::Point point = shotPoint(1);
    point.id = QStringLiteral("x'); DROP TABLE points; --");
    point.station_name = QStringLiteral("s' OR '1'='1");
    point.remark = QStringLiteral("a") + QChar(0) + QStringLiteral("b");
    ASSERT_TRUE(job->record(point).has_value());
    EXPECT_EQ(job->points()->front().id, point.id);
    EXPECT_EQ(job->points()->front().remark, QStringLiteral("a\u2400b"));
}

TEST_F(JobTest, OtherProgramsSeePointsWithHeightAttributesAndTheirReferenceSystem) {
    createWith(3);
    const OtherProgram qgis(path);
    OGRLayer& points = qgis.layer("points");
    EXPECT_EQ(points.GetGeomType(), wkbPoint25D);
    EXPECT_EQ(points.GetFeatureCount(), 3);
    EXPECT_EQ(qgis.value("SELECT srs_id FROM gpkg_geometry_columns WHERE table_name = 'points'"), QStringLiteral("-1"));
    EXPECT_EQ(qgis.value("SELECT hex(substr(geom, 5, 4)) FROM points"),
              QStringLiteral("FFFFFFFF"));  // -1 in each point
    EXPECT_EQ(qgis.value("SELECT HasSpatialIndex('points', 'geom')"), QStringLiteral("1"));
    const OGRFeatureUniquePtr first(points.GetNextFeature());
    EXPECT_EQ(first->GetGeometryRef()->toPoint()->getZ(), 50.489);
    EXPECT_STREQ(first->GetFieldAsString("time_utc"), "2015/07/09 10:20:30.456+00");
    EXPECT_EQ(first->GetFieldAsDouble("ha_gon"), 177.56115);
}

TEST_F(JobTest, KeepsWalAndFullSynchronisation) {
    const auto job = created();
    ASSERT_TRUE(job->record(shotPoint(1)).has_value());
    EXPECT_TRUE(QFile::exists(path + QStringLiteral("-wal")));
    const OtherProgram qgis(path);
    EXPECT_EQ(qgis.value("PRAGMA journal_mode"), QStringLiteral("wal"));
}

TEST_F(JobTest, ClosingLeavesOneFile) {
    createWith(2);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden),
              QStringList{QStringLiteral("facade-12.gpkg")});
}

TEST_F(JobTest, IsNamedAfterItsFile) {
    const auto job = created();
    EXPECT_EQ(job->name(), QStringLiteral("facade-12"));
    EXPECT_EQ(job->path(), path);
}

}  // namespace
}  // namespace pmts::job
