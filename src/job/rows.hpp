#pragma once

#include "pmts/job/job.hpp"
#include "row_fields.hpp"

#include <ogr_feature.h>

#include <optional>

namespace pmts::job {

/// Rows of the tables <-> values. No SQL, no file.

void fillObservation(OGRFeature& row, const survey::Observation& observation,
                     std::optional<qint64> station_row);
[[nodiscard]] survey::Observation observationOf(const OGRFeature& row);

/// Everything of the point but its observation's number.
void fillPoint(OGRFeature& row, const survey::Point& point);
/// Geometry and precision: what changes when a station is oriented anew. NULL geometry without coordinates.
void fillCoordinates(OGRFeature& row, const survey::Point& point);
/// What the surveyor may edit: ID, code, remark, struck out.
void fillNames(OGRFeature& row, const survey::Point& point);
[[nodiscard]] survey::Point pointOf(const OGRFeature& row, const survey::Observation& observation);

void fillStation(OGRFeature& row, const survey::Station& station);
[[nodiscard]] survey::Station stationOf(const OGRFeature& row);

void fillPhoto(OGRFeature& row, const Photo& photo);
/// Without the image.
[[nodiscard]] Photo photoOf(const OGRFeature& row);

void fillLogEntry(OGRFeature& row, const LogEntry& entry);
[[nodiscard]] LogEntry logEntryOf(const OGRFeature& row);

void fillEvidence(OGRFeature& row, const Evidence& evidence, qint64 point_row);
[[nodiscard]] Evidence evidenceOfRow(const OGRFeature& row);

/// A planned point that has a number keeps it.
void fillPlanned(OGRFeature& row, const survey::PlannedPoint& point);
[[nodiscard]] survey::PlannedPoint plannedOf(const OGRFeature& row);

void fillMark(OGRFeature& row, const ImageMark& mark);
[[nodiscard]] ImageMark markOf(const OGRFeature& row);

}  // namespace pmts::job
