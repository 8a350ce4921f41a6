#include "pmts/app/field/photo_circumstances.hpp"

#include <array>

namespace pmts::app {

namespace {

const QString kKey = QStringLiteral("taken");
constexpr std::array<RangeSource, 5> kSources{RangeSource::kMeasured, RangeSource::kPlane, RangeSource::kPlanned,
                                              RangeSource::kLastShot, RangeSource::kAssumed};

std::optional<double> numberOf(const QJsonObject& object, const char* key) {
    const QJsonValue value = object.value(QLatin1String(key));
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

std::optional<survey::Station> stationOf(const QJsonObject& object) {
    const auto e_m = numberOf(object, "e_m"), n_m = numberOf(object, "n_m"), h_m = numberOf(object, "h_m");
    if (!e_m || !n_m || !h_m) {
        return std::nullopt;
    }
    survey::Station station;
    station.name = object.value(QLatin1String("name")).toString();
    station.e_m = *e_m;
    station.n_m = *n_m;
    station.h_m = *h_m;
    station.instrument_height_m = numberOf(object, "instrument_height_m").value_or(0.0);
    station.orientation = core::Angle::fromGon(numberOf(object, "orientation_gon").value_or(0.0));
    return station;
}

}  // namespace

QString rangeSourceKey(RangeSource source) {
    switch (source) {
        case RangeSource::kMeasured: return QStringLiteral("measured");
        case RangeSource::kPlane: return QStringLiteral("plane");
        case RangeSource::kPlanned: return QStringLiteral("planned");
        case RangeSource::kLastShot: return QStringLiteral("last shot");
        case RangeSource::kAssumed: return QStringLiteral("assumed");
    }
    return {};
}

QJsonObject withCircumstances(QJsonObject rig_json, const PhotoCircumstances& taken) {
    QJsonObject object;
    if (!taken.camera.isEmpty()) {
        object.insert(QStringLiteral("camera"), taken.camera);
    }
    if (taken.range) {
        object.insert(QStringLiteral("slope_distance_m"), taken.range->slope_distance_m);
        object.insert(QStringLiteral("range_source"), rangeSourceKey(taken.range->source));
    }
    if (taken.station) {
        object.insert(QStringLiteral("station"), QJsonObject{{"name", taken.station->name},
                                                             {"e_m", taken.station->e_m},
                                                             {"n_m", taken.station->n_m},
                                                             {"h_m", taken.station->h_m},
                                                             {"instrument_height_m", taken.station->instrument_height_m},
                                                             {"orientation_gon", taken.station->orientation.gon()}});
    }
    rig_json.insert(kKey, object);
    return rig_json;
}

PhotoCircumstances circumstancesOf(const QJsonObject& rig_json) {
    const QJsonObject object = rig_json.value(kKey).toObject();
    PhotoCircumstances taken;
    taken.camera = object.value(QLatin1String("camera")).toString();
    const auto distance_m = numberOf(object, "slope_distance_m");
    const QString source = object.value(QLatin1String("range_source")).toString();
    for (const RangeSource known : kSources) {
        if (distance_m && rangeSourceKey(known) == source) {
            taken.range = RangeAssumption{.slope_distance_m = *distance_m, .source = known};
        }
    }
    taken.station = stationOf(object.value(QLatin1String("station")).toObject());
    return taken;
}

}  // namespace pmts::app
