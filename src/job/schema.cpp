#include "schema.hpp"

#include "gdal_session.hpp"
#include "pmts/job/job.hpp"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <span>

namespace pmts::job {
namespace {

struct Column {
    const char* name;
    OGRFieldType type;
    OGRFieldSubType subtype = OFSTNone;
    const char* standard = nullptr;  ///< SQL default
};

constexpr std::array kPointColumns{
    Column{"id", OFTString},
    Column{"code", OFTString},
    Column{"remark", OFTString},
    Column{"struck_out", OFTInteger, OFSTBoolean, "0"},
    Column{"station", OFTString},
    Column{"sigma_e_m", OFTReal},
    Column{"sigma_n_m", OFTReal},
    Column{"sigma_h_m", OFTReal},
    Column{"ha_gon", OFTReal},
    Column{"va_gon", OFTReal},
    Column{"sd_m", OFTReal},
    Column{"target_height_m", OFTReal},
    Column{"mode", OFTString},
    Column{"time_utc", OFTDateTime},
    Column{"observation", OFTInteger64},
};

constexpr std::array kObservationColumns{
    Column{"ha_gon", OFTReal},          Column{"va_gon", OFTReal},           Column{"sd_m", OFTReal},
    Column{"absurd_reason", OFTString}, Column{"target_height_m", OFTReal},  Column{"mode", OFTString},
    Column{"time_taken_s", OFTReal},    Column{"time_utc", OFTDateTime},     Column{"raw_reply", OFTString},
    Column{"source", OFTString},        Column{"station_row", OFTInteger64},
};

constexpr std::array kStationColumns{
    Column{"name", OFTString},
    Column{"e_m", OFTReal},
    Column{"n_m", OFTReal},
    Column{"h_m", OFTReal},
    Column{"instrument_height_m", OFTReal},
    Column{"orientation_gon", OFTReal},
    Column{"written_utc", OFTDateTime, OFSTNone, "(strftime('%Y-%m-%dT%H:%M:%fZ','now'))"},
};

constexpr std::array kPhotoColumns{
    Column{"name", OFTString},     Column{"image", OFTBinary},   Column{"ha_gon", OFTReal},
    Column{"va_gon", OFTReal},     Column{"station", OFTString}, Column{"time_utc", OFTDateTime},
    Column{"rig_json", OFTString},
};

constexpr std::array kEvidenceColumns{
    Column{"point_row", OFTInteger64},
    Column{"method", OFTString},
    Column{"recentred", OFTInteger, OFSTBoolean},
    Column{"ha_gon", OFTReal},
    Column{"va_gon", OFTReal},
    Column{"residual_x_px", OFTReal},
    Column{"residual_y_px", OFTReal},
    Column{"residual_gon", OFTReal},
    Column{"tolerance_px", OFTReal},
    Column{"tolerance_gon", OFTReal},
    Column{"score", OFTReal},
    Column{"runner_up", OFTReal},
    Column{"sigma_px", OFTReal},
    Column{"moves", OFTInteger},
    Column{"sd_m", OFTReal},
    Column{"sd_source", OFTString},
    Column{"time_utc", OFTDateTime},
    Column{"before_image", OFTBinary},
    Column{"before_spot_x_px", OFTReal},
    Column{"before_spot_y_px", OFTReal},
    Column{"before_reticle_x_px", OFTReal},
    Column{"before_reticle_y_px", OFTReal},
    Column{"after_image", OFTBinary},
    Column{"after_spot_x_px", OFTReal},
    Column{"after_spot_y_px", OFTReal},
    Column{"after_reticle_x_px", OFTReal},
    Column{"after_reticle_y_px", OFTReal},
};

constexpr std::array kPlannedColumns{
    Column{"id", OFTString},
    Column{"code", OFTString},
    Column{"remark", OFTString},
};

constexpr std::array kMarkColumns{
    Column{"photo", OFTInteger64},
    Column{"x_px", OFTReal},
    Column{"y_px", OFTReal},
    Column{"label", OFTString},
};

constexpr std::array kLogColumns{
    Column{"time_utc", OFTDateTime},
    Column{"category", OFTString},
    Column{"text", OFTString},
};

constexpr std::array kMetaColumns{
    Column{"key", OFTString},
    Column{"value", OFTString},
};

struct Table {
    const char* name;
    OGRwkbGeometryType geometry;
    std::span<const Column> columns;
};

const std::array kTables{
    Table{kPoints, wkbPoint25D, kPointColumns},  Table{kObservations, wkbNone, kObservationColumns},
    Table{kStations, wkbNone, kStationColumns},  Table{kPhotos, wkbNone, kPhotoColumns},
    Table{kLog, wkbNone, kLogColumns},           Table{kMeta, wkbNone, kMetaColumns},
    Table{kEvidence, wkbNone, kEvidenceColumns}, Table{kPlannedPoints, wkbPoint25D, kPlannedColumns},
    Table{kImageMarks, wkbNone, kMarkColumns},
};

bool addColumn(OGRLayer& layer, const Column& column) {
    OGRFieldDefn field(column.name, column.type);
    field.SetSubType(column.subtype);
    field.SetDefault(column.standard);
    return layer.CreateField(&field) == OGRERR_NONE;
}

bool createTable(GDALDataset& dataset, const Table& table) {
    OGRLayer* const layer = dataset.CreateLayer(table.name, nullptr, table.geometry, nullptr);
    if (layer == nullptr) {
        return false;
    }
    for (const Column& column : table.columns) {
        if (!addColumn(*layer, column)) {
            return false;
        }
    }
    return layer->SyncToDisk() == OGRERR_NONE;
}

const Table& tableNamed(const char* name) {
    return *std::find_if(kTables.begin(), kTables.end(),
                         [name](const Table& t) { return qstrcmp(t.name, name) == 0; });
}

/// `event` on the table ends with an error that says why, in every program that writes.
bool forbid(GDALDataset& dataset, const char* table, const char* event, const char* why,
            const QString& when = {}) {
    return runSql(dataset, QStringLiteral("CREATE TRIGGER IF NOT EXISTS %1_no_%2 BEFORE %3 ON %1 %4"
                                          "BEGIN SELECT RAISE(ABORT, '%5'); END")
                               .arg(QLatin1String(table), QString::fromLatin1(event).toLower(),
                                    QLatin1String(event), when, QLatin1String(why)));
}

/// Neither changed nor removed. REPLACE removes without a DELETE trigger: a number already taken is refused.
bool makeImmutable(GDALDataset& dataset, const char* table, const char* why) {
    const QString taken =
        QStringLiteral("WHEN EXISTS (SELECT 1 FROM %1 WHERE fid = NEW.fid) ").arg(QLatin1String(table));
    return forbid(dataset, table, "UPDATE", why) && forbid(dataset, table, "DELETE", why) &&
           forbid(dataset, table, "INSERT", why, taken);
}

bool protectRawData(GDALDataset& dataset) {
    return makeImmutable(dataset, kObservations, "observations are never changed") &&
           makeImmutable(dataset, kStations, "stations are never changed, a change is a new row") &&
           forbid(dataset, kPoints, "DELETE", "points are struck out, never deleted");
}

/// E, N, H are plain engineering coordinates: srs_id -1 of the standard, undefined Cartesian.
bool useEngineeringCoordinates(GDALDataset& dataset, const char* layer) {
    const auto apply = [&](const char* table) {
        return runSql(dataset, QStringLiteral("UPDATE %1 SET srs_id = -1 WHERE table_name = '%2'")
                                   .arg(QLatin1String(table), QLatin1String(layer)));
    };
    return apply("gpkg_geometry_columns") && apply("gpkg_contents");
}

bool protectEvidence(GDALDataset& dataset) {
    return makeImmutable(dataset, kEvidence, "evidence is never changed") &&
           runSql(dataset,
                  QStringLiteral("CREATE INDEX IF NOT EXISTS evidence_point ON evidence (point_row)"));
}

bool writeMeta(GDALDataset& dataset, const char* key, const QString& value) {
    return runSql(dataset, QStringLiteral("INSERT INTO meta (key, value) VALUES ('%1', '%2') "
                                          "ON CONFLICT (key) DO UPDATE SET value = excluded.value")
                               .arg(QLatin1String(key), value));
}

/// Schema 0, before the first release: no log, no source of an observation, no rig of a photo.
bool migrateFrom0(GDALDataset& dataset) {
    OGRLayer* const observations = dataset.GetLayerByName(kObservations);
    OGRLayer* const photos = dataset.GetLayerByName(kPhotos);
    return observations != nullptr && photos != nullptr && addColumn(*observations, {"source", OFTString}) &&
           addColumn(*observations, {"station_row", OFTInteger64}) &&
           addColumn(*photos, {"rig_json", OFTString}) && createTable(dataset, tableNamed(kLog)) &&
           protectRawData(dataset);
}

/// Schema 1: no evidence of aiming by image, no planned points, no marks in photos.
bool migrateFrom1(GDALDataset& dataset) {
    return createTable(dataset, tableNamed(kEvidence)) && createTable(dataset, tableNamed(kPlannedPoints)) &&
           createTable(dataset, tableNamed(kImageMarks)) &&
           useEngineeringCoordinates(dataset, kPlannedPoints) && protectEvidence(dataset);
}

bool repairLayer(GDALDataset& dataset, const char* name) {
    const QLatin1String layer(name);
    const auto sql = [&](const char* text) { return QString::fromLatin1(text).arg(layer); };
    if (queryText(dataset, sql("SELECT HasSpatialIndex('%1', 'geom')")) != u"1" &&
        !runSql(dataset, sql("SELECT CreateSpatialIndex('%1', 'geom')"))) {
        return false;
    }
    return runSql(dataset, sql("UPDATE gpkg_ogr_contents SET feature_count = (SELECT COUNT(*) FROM %1) "
                               "WHERE table_name = '%1'")) &&
           runSql(dataset, sql("RECOMPUTE EXTENT ON %1"));
}

}  // namespace

bool createTables(GDALDataset& dataset) {
    return std::all_of(kTables.begin(), kTables.end(),
                       [&](const Table& table) { return createTable(dataset, table); });
}

bool finishTables(GDALDataset& dataset) {
    return useEngineeringCoordinates(dataset, kPoints) &&
           useEngineeringCoordinates(dataset, kPlannedPoints) && protectRawData(dataset) &&
           protectEvidence(dataset) &&
           runSql(dataset, QStringLiteral("CREATE UNIQUE INDEX meta_key ON meta (key)")) &&
           writeMeta(dataset, kApplicationKey, QLatin1String(kApplication)) &&
           writeMeta(dataset, kSchemaKey, QString::number(Job::kSchemaVersion));
}

std::optional<int> schemaVersion(GDALDataset& dataset) {
    if (dataset.GetLayerByName(kMeta) == nullptr) {
        return std::nullopt;
    }
    const auto value = [&](const char* key) {
        return queryText(dataset,
                         QStringLiteral("SELECT value FROM meta WHERE key = '%1'").arg(QLatin1String(key)));
    };
    bool is_number = false;
    const int version = value(kSchemaKey).toInt(&is_number);
    return value(kApplicationKey) == QLatin1String(kApplication) && is_number ? std::optional(version)
                                                                              : std::nullopt;
}

bool migrate(GDALDataset& dataset, int from) {
    if (dataset.StartTransaction() != OGRERR_NONE) {
        return false;
    }
    const bool done = (from > 0 || migrateFrom0(dataset)) && (from > 1 || migrateFrom1(dataset)) &&
                      writeMeta(dataset, kSchemaKey, QString::number(Job::kSchemaVersion));
    if (done) {
        return dataset.CommitTransaction() == OGRERR_NONE;
    }
    dataset.RollbackTransaction();
    return false;
}

QString missingColumn(GDALDataset& dataset) {
    for (const Table& table : kTables) {
        OGRLayer* const layer = dataset.GetLayerByName(table.name);
        if (layer == nullptr) {
            return QLatin1String(table.name);
        }
        for (const Column& column : table.columns) {
            if (layer->GetLayerDefn()->GetFieldIndex(column.name) < 0) {
                return QLatin1String(table.name) + u'.' + QLatin1String(column.name);
            }
        }
    }
    return {};
}

bool writePlannedExtent(GDALDataset& dataset) {
    return runSql(dataset, QStringLiteral("RECOMPUTE EXTENT ON planned_points"));
}

bool repairContents(GDALDataset& dataset) {
    return repairLayer(dataset, kPoints) && repairLayer(dataset, kPlannedPoints);
}

}  // namespace pmts::job
