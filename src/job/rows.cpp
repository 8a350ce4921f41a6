#include "rows.hpp"

#include "row_fields.hpp"

#include <ogr_geometry.h>

namespace pmts::job {
namespace {

/// The row's point; null when another program left it without one.
const OGRPoint* placeOf(const OGRFeature& row) {
    const OGRGeometry* const geometry = row.GetGeometryRef();
    const bool is_point = geometry != nullptr && wkbFlatten(geometry->getGeometryType()) == wkbPoint;
    return is_point && !geometry->IsEmpty() ? geometry->toPoint() : nullptr;
}

}  // namespace

void fillObservation(OGRFeature& row, const survey::Observation& observation,
                     std::optional<qint64> station_row) {
    setPointing(row, observation.pointing);
    setNumber(row, "sd_m", observation.slope_distance_m);
    setText(row, "absurd_reason", observation.absurd_reason);
    row.SetField("target_height_m", observation.target_height_m);
    setText(row, "mode", observation.edm_mode);
    row.SetField("time_taken_s", observation.time_taken_s);
    setTime(row, "time_utc", observation.utc);
    setText(row, "raw_reply", observation.raw_reply);
    setText(row, "source", observation.source);
    if (station_row) {
        row.SetField("station_row", static_cast<GIntBig>(*station_row));
    }
}

survey::Observation observationOf(const OGRFeature& row) {
    survey::Observation observation;
    observation.pointing = pointingOf(row);
    observation.slope_distance_m = numberOf(row, "sd_m");
    observation.absurd_reason = textOf(row, "absurd_reason");
    observation.target_height_m = numberOf(row, "target_height_m").value_or(0.0);
    observation.edm_mode = textOf(row, "mode");
    observation.time_taken_s = numberOf(row, "time_taken_s").value_or(0.0);
    observation.utc = timeOf(row, "time_utc");
    observation.raw_reply = textOf(row, "raw_reply");
    if (const QString source = textOf(row, "source"); !source.isEmpty()) {  // schema 0 did not keep it
        observation.source = source;
    }
    return observation;
}

void fillNames(OGRFeature& row, const survey::Point& point) {
    setText(row, "id", point.id);
    setText(row, "code", point.code);
    setText(row, "remark", point.remark);
    row.SetField("struck_out", point.struck_out ? 1 : 0);
}

void fillCoordinates(OGRFeature& row, const survey::Point& point) {
    if (!point.hasCoordinates()) {
        row.SetGeometry(nullptr);
        for (const char* column : {"sigma_e_m", "sigma_n_m", "sigma_h_m"}) {
            setNumber(row, column, std::nullopt);
        }
        return;
    }
    const auto& at = point.coordinates;
    const OGRPoint geometry(at.e_m, at.n_m, at.h_m);
    row.SetGeometry(&geometry);
    row.SetField("sigma_e_m", at.sigma_e_m);
    row.SetField("sigma_n_m", at.sigma_n_m);
    row.SetField("sigma_h_m", at.sigma_h_m);
}

void fillPoint(OGRFeature& row, const survey::Point& point) {
    fillNames(row, point);
    fillCoordinates(row, point);
    setText(row, "station", point.station_name);
    setPointing(row, point.observation.pointing);
    setNumber(row, "sd_m", point.observation.slope_distance_m);
    row.SetField("target_height_m", point.observation.target_height_m);
    setText(row, "mode", point.observation.edm_mode);
    setTime(row, "time_utc", point.observation.utc);
}

survey::Point pointOf(const OGRFeature& row, const survey::Observation& observation) {
    survey::Point point;
    point.row_id = row.GetFID();
    point.id = textOf(row, "id");
    point.code = textOf(row, "code");
    point.remark = textOf(row, "remark");
    point.struck_out = row.GetFieldAsInteger("struck_out") != 0;
    point.station_name = textOf(row, "station");
    point.observation = observation;
    if (const OGRPoint* const at = placeOf(row)) {
        point.coordinates.e_m = at->getX();
        point.coordinates.n_m = at->getY();
        point.coordinates.h_m = at->getZ();
    }
    point.coordinates.sigma_e_m = numberOf(row, "sigma_e_m").value_or(0.0);
    point.coordinates.sigma_n_m = numberOf(row, "sigma_n_m").value_or(0.0);
    point.coordinates.sigma_h_m = numberOf(row, "sigma_h_m").value_or(0.0);
    return point;
}

void fillStation(OGRFeature& row, const survey::Station& station) {
    setText(row, "name", station.name);
    row.SetField("e_m", station.e_m);
    row.SetField("n_m", station.n_m);
    row.SetField("h_m", station.h_m);
    row.SetField("instrument_height_m", station.instrument_height_m);
    row.SetField("orientation_gon", station.orientation.gon());
}

survey::Station stationOf(const OGRFeature& row) {
    return {
        .name = textOf(row, "name"),
        .e_m = row.GetFieldAsDouble("e_m"),
        .n_m = row.GetFieldAsDouble("n_m"),
        .h_m = row.GetFieldAsDouble("h_m"),
        .instrument_height_m = row.GetFieldAsDouble("instrument_height_m"),
        .orientation = angleOf(row, "orientation_gon"),
    };
}

void fillPhoto(OGRFeature& row, const Photo& photo) {
    setText(row, "name", photo.name);
    setBytes(row, "image", photo.encoded_image);
    setPointing(row, photo.pointing);
    setText(row, "station", photo.station_name);
    setTime(row, "time_utc", photo.utc);
    setText(row, "rig_json", photo.rig_json);
}

Photo photoOf(const OGRFeature& row) {
    Photo photo;
    photo.row_id = row.GetFID();
    photo.name = textOf(row, "name");
    photo.pointing = pointingOf(row);
    photo.station_name = textOf(row, "station");
    photo.utc = timeOf(row, "time_utc");
    photo.rig_json = textOf(row, "rig_json");
    return photo;
}

void fillLogEntry(OGRFeature& row, const LogEntry& entry) {
    setTime(row, "time_utc", entry.utc);
    setText(row, "category", entry.category);
    setText(row, "text", entry.text);
}

LogEntry logEntryOf(const OGRFeature& row) {
    return {.utc = timeOf(row, "time_utc"), .category = textOf(row, "category"), .text = textOf(row, "text")};
}

void fillPlanned(OGRFeature& row, const survey::PlannedPoint& point) {
    if (point.row_id != 0) {
        row.SetFID(point.row_id);
    }
    setText(row, "id", point.id);
    setText(row, "code", point.code);
    setText(row, "remark", point.remark);
    const OGRPoint geometry(point.e_m, point.n_m, point.h_m);
    row.SetGeometry(&geometry);
}

survey::PlannedPoint plannedOf(const OGRFeature& row) {
    survey::PlannedPoint point{.row_id = row.GetFID(),
                               .id = textOf(row, "id"),
                               .code = textOf(row, "code"),
                               .remark = textOf(row, "remark")};
    if (const OGRPoint* const at = placeOf(row)) {
        point.e_m = at->getX();
        point.n_m = at->getY();
        point.h_m = at->getZ();
    }
    return point;
}

void fillMark(OGRFeature& row, const ImageMark& mark) {
    row.SetField("photo", static_cast<GIntBig>(mark.photo_row));
    row.SetField("x_px", mark.x_px);
    row.SetField("y_px", mark.y_px);
    setText(row, "label", mark.label);
}

ImageMark markOf(const OGRFeature& row) {
    return {.row_id = row.GetFID(),
            .photo_row = row.GetFieldAsInteger64("photo"),
            .x_px = numberOf(row, "x_px").value_or(0.0),
            .y_px = numberOf(row, "y_px").value_or(0.0),
            .label = textOf(row, "label")};
}

}  // namespace pmts::job
