#include "rows.hpp"

#include <QTimeZone>
#include <ogr_geometry.h>

#include <cmath>

namespace pmts::job {
namespace {

constexpr int kUtcFlag = 100;  ///< OGR's time zone flag of UTC

void setTime(OGRFeature& row, const char* column, const QDateTime& time) {
    if (!time.isValid()) {
        row.SetFieldNull(row.GetFieldIndex(column));
        return;
    }
    const QDateTime utc = time.toUTC();
    const QDate day = utc.date();
    const QTime clock = utc.time();
    row.SetField(column, day.year(), day.month(), day.day(), clock.hour(), clock.minute(),
                 static_cast<float>(clock.second() + clock.msec() / 1000.0), kUtcFlag);
}

QDateTime timeOf(const OGRFeature& row, const char* column) {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, zone = 0;
    float second = 0.0F;
    if (!row.GetFieldAsDateTime(row.GetFieldIndex(column), &year, &month, &day, &hour, &minute, &second,
                                &zone)) {
        return {};
    }
    const QDateTime whole_minute(QDate(year, month, day), QTime(hour, minute), Qt::UTC);
    return whole_minute.addMSecs(std::lround(second * 1000.0));
}

void setNumber(OGRFeature& row, const char* column, std::optional<double> number) {
    if (number) {
        row.SetField(column, *number);
    } else {
        row.SetFieldNull(row.GetFieldIndex(column));
    }
}

std::optional<double> numberOf(const OGRFeature& row, const char* column) {
    const int index = row.GetFieldIndex(column);
    return index >= 0 && row.IsFieldSetAndNotNull(index) ? std::optional(row.GetFieldAsDouble(index))
                                                         : std::nullopt;
}

core::Angle angleOf(const OGRFeature& row, const char* column) {
    return core::Angle::fromGon(numberOf(row, column).value_or(0.0));
}

geometry::Pointing pointingOf(const OGRFeature& row) {
    return {.ha = angleOf(row, "ha_gon"), .va = angleOf(row, "va_gon")};
}

void setPointing(OGRFeature& row, const geometry::Pointing& pointing) {
    row.SetField("ha_gon", pointing.ha.gon());
    row.SetField("va_gon", pointing.va.gon());
}

}  // namespace

void setText(OGRFeature& row, const char* column, const QString& text) {
    QString plain = text;
    plain.replace(QChar(0), QChar(0x2400));
    row.SetField(column, plain.toUtf8().constData());
}

QString textOf(const OGRFeature& row, const char* column) {
    return QString::fromUtf8(row.GetFieldAsString(column));
}

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
    const OGRGeometry* const geometry = row.GetGeometryRef();
    if (geometry != nullptr && wkbFlatten(geometry->getGeometryType()) == wkbPoint && !geometry->IsEmpty()) {
        const OGRPoint& at = *geometry->toPoint();
        point.coordinates.e_m = at.getX();
        point.coordinates.n_m = at.getY();
        point.coordinates.h_m = at.getZ();
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
    row.SetField(row.GetFieldIndex("image"), static_cast<int>(photo.encoded_image.size()),
                 static_cast<const void*>(photo.encoded_image.constData()));
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

}  // namespace pmts::job
