#include "pmts/app/lab/calibration_record.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pmts::app {

namespace {

QString say(const char* text) { return QCoreApplication::translate("CalibrationRecord", text); }

// Names in the file stay when the enumerators move.
constexpr std::array<std::pair<CalibrationMethod, const char*>, 7> kMethods{{
    {CalibrationMethod::kOther, "other"},
    {CalibrationMethod::kSelfCalibration, "self_calibration"},
    {CalibrationMethod::kSightings, "sightings"},
    {CalibrationMethod::kDistortionTable, "distortion_table"},
    {CalibrationMethod::kBoard, "board"},
    {CalibrationMethod::kMounting, "mounting"},
    {CalibrationMethod::kImported, "imported"},
}};
constexpr std::array<std::pair<video::SourceKind, const char*>, 5> kSources{{
    {video::SourceKind::kSimulated, "simulated"},
    {video::SourceKind::kV4l2, "v4l2"},
    {video::SourceKind::kQtCamera, "qt"},
    {video::SourceKind::kFile, "file"},
    {video::SourceKind::kStream, "stream"},
}};

template <class Table, class Value>
QString nameOf(const Table& table, Value value) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.first == value; });
    return QLatin1String(found == table.end() ? table.front().second : found->second);
}

template <class Table>
auto valueOf(const Table& table, const QString& name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& row) { return name == QLatin1String(row.second); });
    return found == table.end() ? table.front().first : found->first;
}

std::optional<double> numberOf(const QJsonObject& json, const char* name) {
    const QJsonValue value = json.value(QLatin1String(name));
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

void insert(QJsonObject& json, const char* name, const std::optional<double>& value) {
    if (value && std::isfinite(*value)) {
        json.insert(QLatin1String(name), *value);
    }
}

}  // namespace

QString useText(const CameraUse& use) {
    QStringList parts;
    parts.append(!use.camera.isEmpty() ? use.camera : use.isSimulated() ? say("Simulated camera") : say("any camera"));
    if (!use.size.isEmpty()) {
        parts.append(QStringLiteral("%1x%2 %3").arg(use.size.width()).arg(use.size.height()).arg(use.pixel_format).trimmed());
    }
    if (use.focus) {
        parts.append(say("focus %1").arg(*use.focus));
    }
    if (use.zoom) {
        parts.append(say("zoom %1").arg(*use.zoom));
    }
    return parts.join(QStringLiteral(", "));
}

QString methodText(CalibrationMethod method) {
    switch (method) {
        case CalibrationMethod::kOther: return say("typed in");
        case CalibrationMethod::kSelfCalibration: return say("self-calibration");
        case CalibrationMethod::kSightings: return say("sighted targets");
        case CalibrationMethod::kDistortionTable: return say("distortion table");
        case CalibrationMethod::kBoard: return say("board");
        case CalibrationMethod::kMounting: return say("mounting boards");
        case CalibrationMethod::kImported: return say("imported");
    }
    return {};
}

QJsonArray residualsToJson(const std::vector<RecordedResidual>& residuals) {
    QJsonArray rows;
    for (const RecordedResidual& r : residuals) {
        rows.append(QJsonArray{r.px.x(), r.px.y(), r.residual_px.x(), r.residual_px.y(), r.held_out ? 1 : 0});
    }
    return rows;
}

std::vector<RecordedResidual> residualsFromJson(const QJsonArray& rows) {
    std::vector<RecordedResidual> residuals;
    for (const auto& value : rows) {
        const QJsonArray row = value.toArray();
        if (row.size() >= 4) {
            residuals.push_back({.px = {row[0].toDouble(), row[1].toDouble()},
                                 .residual_px = {row[2].toDouble(), row[3].toDouble()},
                                 .held_out = row.at(4).toInt() != 0});
        }
    }
    return residuals;
}

QJsonObject cameraUseToJson(const CameraUse& use) {
    QJsonObject json{{"source", nameOf(kSources, use.source)}, {"camera", use.camera}};
    if (!use.size.isEmpty()) {
        json.insert(QStringLiteral("width_px"), use.size.width());
        json.insert(QStringLiteral("height_px"), use.size.height());
    }
    if (!use.pixel_format.isEmpty()) {
        json.insert(QStringLiteral("pixel_format"), use.pixel_format);
    }
    insert(json, "focus", use.focus);
    insert(json, "zoom", use.zoom);
    return json;
}

CameraUse cameraUseFromJson(const QJsonObject& json) {
    return {.source = valueOf(kSources, json.value(QLatin1String("source")).toString()),
            .camera = json.value(QLatin1String("camera")).toString(),
            .size = QSize(json.value(QLatin1String("width_px")).toInt(), json.value(QLatin1String("height_px")).toInt()),
            .pixel_format = json.value(QLatin1String("pixel_format")).toString(),
            .focus = numberOf(json, "focus"),
            .zoom = numberOf(json, "zoom")};
}

QJsonObject calibrationRecordToJson(const CalibrationRecord& record) {
    QJsonObject deviations;
    for (const auto& [name, value] : record.standard_deviations) {
        deviations.insert(name, value);
    }
    QJsonObject json{{"method", nameOf(kMethods, record.method)},
                     {"utc", record.utc.toUTC().toString(Qt::ISODateWithMs)},
                     {"rms_px", record.rms_px},
                     {"camera", cameraUseToJson(record.camera)},
                     {"instrument", record.instrument},
                     {"remark", record.remark},
                     {"standard_deviations", deviations},
                     {"residuals", residualsToJson(record.residuals)}};
    insert(json, "held_out_px", record.held_out_px);
    insert(json, "temperature_c", record.temperature_c);
    return json;
}

CalibrationRecord calibrationRecordFromJson(const QJsonObject& json) {
    CalibrationRecord record{.method = valueOf(kMethods, json.value(QLatin1String("method")).toString()),
                             .utc = QDateTime::fromString(json.value(QLatin1String("utc")).toString(), Qt::ISODateWithMs).toUTC(),
                             .rms_px = json.value(QLatin1String("rms_px")).toDouble(),
                             .held_out_px = numberOf(json, "held_out_px"),
                             .temperature_c = numberOf(json, "temperature_c"),
                             .camera = cameraUseFromJson(json.value(QLatin1String("camera")).toObject()),
                             .instrument = json.value(QLatin1String("instrument")).toString(),
                             .remark = json.value(QLatin1String("remark")).toString(),
                             .standard_deviations = {},
                             .residuals = residualsFromJson(json.value(QLatin1String("residuals")).toArray())};
    const QJsonObject deviations = json.value(QLatin1String("standard_deviations")).toObject();
    for (auto entry = deviations.begin(); entry != deviations.end(); ++entry) {
        if (entry->isDouble()) {
            record.standard_deviations.emplace(entry.key(), entry->toDouble());
        }
    }
    return record;
}

}  // namespace pmts::app
