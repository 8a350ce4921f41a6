#pragma once

#include "pmts/core/result.hpp"

#include <QString>
#include <gdal_priv.h>

#include <optional>

namespace pmts::job {

/// Names of the tables; docs/job-format.md lists their columns.
inline constexpr const char* kPoints = "points";
inline constexpr const char* kObservations = "observations";
inline constexpr const char* kStations = "stations";
inline constexpr const char* kPhotos = "photos";
inline constexpr const char* kLog = "log";
inline constexpr const char* kEvidence = "evidence";
inline constexpr const char* kPlannedPoints = "planned_points";
inline constexpr const char* kImageMarks = "image_marks";
inline constexpr const char* kMeta = "meta";

/// Rows of `meta` that belong to the file and not to the surveyor.
inline constexpr const char* kApplicationKey = "application";
inline constexpr const char* kApplication = "PMTS";
inline constexpr const char* kSchemaKey = "schema_version";

/// Creates every table and column; the caller closes and reopens the file before it goes on (spatial index).
[[nodiscard]] bool createTables(GDALDataset& dataset);

/// Second step of creation: triggers that keep raw data raw, the engineering coordinate system, the file's
/// own meta rows.
[[nodiscard]] bool finishTables(GDALDataset& dataset);

/// Number in `meta`; absent when this is no job of ours.
[[nodiscard]] std::optional<int> schemaVersion(GDALDataset& dataset);

/// Brings an older job up to Job::kSchemaVersion in one transaction: all or nothing.
[[nodiscard]] bool migrate(GDALDataset& dataset, int from);

/// First table or column that should be there and is not, as `table.column`; empty when all are.
[[nodiscard]] QString missingColumn(GDALDataset& dataset);

/// Makes the extent of the planned points true in the contents table.
[[nodiscard]] bool writePlannedExtent(GDALDataset& dataset);

/// Makes counts, extent and spatial index true again: a killed session leaves them empty or old.
[[nodiscard]] bool repairContents(GDALDataset& dataset);

}  // namespace pmts::job
