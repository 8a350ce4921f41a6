#pragma once

#include "pmts/app/field/range_keeper.hpp"
#include "pmts/survey/station.hpp"

#include <QJsonObject>
#include <QString>

#include <optional>

namespace pmts::app {

/// What was known when a photo was taken, beside its pointing and rig. Kept in the photo's rig JSON under `taken`.
struct PhotoCircumstances {
    QString camera;                             ///< empty: not known
    std::optional<RangeAssumption> range;       ///< slope distance along the axis, and where it was from
    std::optional<survey::Station> station;     ///< as it was then
};

[[nodiscard]] QJsonObject withCircumstances(QJsonObject rig_json, const PhotoCircumstances& taken);
/// What the JSON tells; older photos tell nothing.
[[nodiscard]] PhotoCircumstances circumstancesOf(const QJsonObject& rig_json);
/// `measured`, `plane`, `planned`, `last shot`, `assumed`: for files, never translated.
[[nodiscard]] QString rangeSourceKey(RangeSource source);

}  // namespace pmts::app
