#include "job_support.hpp"

namespace pmts::job {
namespace {

/// What was written before the first release: no log, no source, no number of the set-up, no rig; E, N, H as
/// today.
class VersionZeroFile {
public:
    explicit VersionZeroFile(const QString& path) {
        GDALAllRegister();
        GDALDataset* const file = GetGDALDriverManager()->GetDriverByName("GPKG")->Create(
            path.toUtf8().constData(), 0, 0, 0, GDT_Unknown, nullptr);
        addTable(*file, "points", wkbPoint25D,
                 {{"id", OFTString},
                  {"code", OFTString},
                  {"remark", OFTString},
                  {"struck_out", OFTInteger},
                  {"station", OFTString},
                  {"sigma_e_m", OFTReal},
                  {"sigma_n_m", OFTReal},
                  {"sigma_h_m", OFTReal},
                  {"ha_gon", OFTReal},
                  {"va_gon", OFTReal},
                  {"sd_m", OFTReal},
                  {"target_height_m", OFTReal},
                  {"mode", OFTString},
                  {"time_utc", OFTDateTime},
                  {"observation", OFTInteger64}});
        addTable(*file, "observations", wkbNone,
                 {{"ha_gon", OFTReal},
                  {"va_gon", OFTReal},
                  {"sd_m", OFTReal},
                  {"absurd_reason", OFTString},
                  {"target_height_m", OFTReal},
                  {"mode", OFTString},
                  {"time_taken_s", OFTReal},
                  {"time_utc", OFTDateTime},
                  {"raw_reply", OFTString}});
        addTable(*file, "stations", wkbNone,
                 {{"name", OFTString},
                  {"e_m", OFTReal},
                  {"n_m", OFTReal},
                  {"h_m", OFTReal},
                  {"instrument_height_m", OFTReal},
                  {"orientation_gon", OFTReal},
                  {"written_utc", OFTDateTime}});
        addTable(*file, "photos", wkbNone,
                 {{"name", OFTString},
                  {"image", OFTBinary},
                  {"ha_gon", OFTReal},
                  {"va_gon", OFTReal},
                  {"station", OFTString},
                  {"time_utc", OFTDateTime}});
        addTable(*file, "meta", wkbNone, {{"key", OFTString}, {"value", OFTString}});
        GDALClose(file);
        OtherProgram editor(path, GDAL_OF_UPDATE);
        for (const char* sql :
             {"CREATE UNIQUE INDEX meta_key ON meta (key)",
              "INSERT INTO meta (key, value) VALUES ('application', 'PMTS'), ('schema_version', '0')",
              "INSERT INTO observations (ha_gon, va_gon, sd_m, mode) VALUES (75, 98.5, 25, 'STD')",
              "INSERT INTO points (id, station, ha_gon, va_gon, sd_m, observation, struck_out, geom) VALUES "
              "('1', '100', 75, 98.5, 25, 1, 0, "
              "X'47500001FFFFFFFF01E90300000000000000408F400000000000409F400000000000000840')"}) {
            EXPECT_EQ(editor.refusal(sql), QString()) << sql;
        }
    }

private:
    struct Column {
        const char* name;
        OGRFieldType type;
    };

    static void addTable(GDALDataset& file, const char* name, OGRwkbGeometryType geometry,
                         std::initializer_list<Column> columns) {
        OGRLayer* const layer = file.CreateLayer(name, nullptr, geometry, nullptr);
        for (const Column& column : columns) {
            OGRFieldDefn field(column.name, column.type);
            layer->CreateField(&field);
        }
    }
};

TEST_F(JobTest, AnOlderJobIsBroughtUpToDateWithAllItHolds) {
    const VersionZeroFile old(path);

    const auto job = reopened();

    const auto points = *job->points();
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points[0].coordinates.e_m, 1000.0);
    EXPECT_EQ(points[0].coordinates.h_m, 3.0);
    EXPECT_EQ(points[0].observation.slope_distance_m, 25.0);
    EXPECT_EQ(points[0].observation.source, QStringLiteral("pmts"));
    EXPECT_TRUE(job->record(shotPoint(2)).has_value());
    EXPECT_TRUE(job->log({{}, QStringLiteral("app"), QStringLiteral("migrated")}).has_value());
    const OtherProgram qgis(path);
    EXPECT_EQ(qgis.value("SELECT value FROM meta WHERE key = 'schema_version'"),
              QString::number(Job::kSchemaVersion));
    EXPECT_EQ(qgis.value("SELECT COUNT(*) FROM sqlite_master WHERE name LIKE 'observations_no_%'"),
              QStringLiteral("3"));
}

/// What the first release wrote: everything but evidence, planned points and marks.
class VersionOneFile : VersionZeroFile {
public:
    explicit VersionOneFile(const QString& path) : VersionZeroFile(path) {
        OtherProgram editor(path, GDAL_OF_UPDATE);
        editor.addTable("log", {{"time_utc", OFTDateTime}, {"category", OFTString}, {"text", OFTString}});
        for (const char* sql : {"ALTER TABLE observations ADD COLUMN source TEXT",
                                "ALTER TABLE observations ADD COLUMN station_row INTEGER",
                                "ALTER TABLE photos ADD COLUMN rig_json TEXT",
                                "CREATE TRIGGER observations_no_update BEFORE UPDATE ON observations "
                                "BEGIN SELECT RAISE(ABORT, 'observations are never changed'); END",
                                "INSERT INTO photos (name, ha_gon, va_gon) VALUES ('north', 10, 100)",
                                "UPDATE meta SET value = '1' WHERE key = 'schema_version'"}) {
            EXPECT_EQ(editor.refusal(sql), QString()) << sql;
        }
    }
};

TEST_F(JobTest, AJobOfTheFirstReleaseGetsPlacesForEvidencePlannedPointsAndMarks) {
    const VersionOneFile old(path);

    const auto job = reopened();

    ASSERT_EQ(job->points()->size(), 1U);
    EXPECT_EQ(job->points()->front().coordinates.e_m, 1000.0);
    EXPECT_FALSE(job->evidenceOf(1)->has_value());
    EXPECT_TRUE(job->record(shotPoint(2), aimedWell()).has_value());
    EXPECT_TRUE(job->addPlanned({survey::PlannedPoint()}).has_value());
    EXPECT_TRUE(job->addMark({.photo_row = 1, .label = QStringLiteral("crack")}).has_value());
    const OtherProgram qgis(path);
    EXPECT_EQ(qgis.value("SELECT value FROM meta WHERE key = 'schema_version'"), QStringLiteral("2"));
    EXPECT_EQ(qgis.layer("planned_points").GetGeomType(), wkbPoint25D);
    EXPECT_EQ(qgis.value("SELECT HasSpatialIndex('planned_points', 'geom')"), QStringLiteral("1"));
}

TEST_F(JobTest, AJobOfTheFirstReleaseStaysOneWhenItCannotBeBroughtUpToDate) {
    const VersionOneFile old(path);
    ASSERT_EQ(OtherProgram(path, GDAL_OF_UPDATE).refusal("CREATE TABLE image_marks (x)"), QString());

    EXPECT_THAT(Job::open(path), test::FailedWith(core::ErrorKind::kFile));

    const OtherProgram qgis(path);
    EXPECT_EQ(qgis.value("SELECT value FROM meta WHERE key = 'schema_version'"), QStringLiteral("1"));
    EXPECT_EQ(qgis.value("SELECT COUNT(*) FROM sqlite_master WHERE name = 'evidence'"), QStringLiteral("0"));
}

TEST_F(JobTest, AMigrationThatCannotFinishLeavesTheOldJob) {
    const VersionZeroFile old(path);
    // A table of that name stands in the way of the new one.
    ASSERT_EQ(OtherProgram(path, GDAL_OF_UPDATE).refusal("CREATE TABLE log (x)"), QString());

    EXPECT_THAT(Job::open(path), test::FailedWith(core::ErrorKind::kFile));

    const OtherProgram qgis(path);
    EXPECT_EQ(qgis.value("SELECT value FROM meta WHERE key = 'schema_version'"), QStringLiteral("0"));
    EXPECT_EQ(qgis.value("SELECT COUNT(*) FROM pragma_table_info('observations') WHERE name = 'source'"),
              QStringLiteral("0"));
}

}  // namespace
}  // namespace pmts::job
