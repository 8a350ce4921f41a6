#include "pmts/app/settings/image_tool_settings.hpp"

#include <QSettings>

namespace pmts::app {

namespace {

std::optional<double> numberOf(const QSettings& file, const char* key, double least, double most) {
    bool is_number = false;
    const double value = file.value(QLatin1String(key)).toDouble(&is_number);
    return is_number && value >= least && value <= most ? std::optional(value) : std::nullopt;
}

std::optional<double> rangeOf(const QSettings& file, const char* key) {
    return numberOf(file, key, ImageToolSettings::kShortest_m, ImageToolSettings::kLongest_m);
}

QVariant orNothing(const std::optional<double>& value) { return value ? QVariant(*value) : QVariant(); }

}  // namespace

void ImageToolSettings::load(const QSettings& file) {
    snap = file.value(QStringLiteral("tools/snap"), snap).toBool();
    loupe_magnification = numberOf(file, "tools/loupe_magnification", kLeastMagnification, kMostMagnification)
                              .value_or(loupe_magnification);
    const auto near_m = rangeOf(file, "tools/parallax_near_m");
    const auto far_m = rangeOf(file, "tools/parallax_far_m");
    if (near_m && far_m && *near_m < *far_m) {
        parallax_near_m = *near_m;
        parallax_far_m = *far_m;
    }
    depth = {.near_m = rangeOf(file, "tools/depth_near_m"), .far_m = rangeOf(file, "tools/depth_far_m")};
}

void ImageToolSettings::save(QSettings& file) const {
    file.setValue(QStringLiteral("tools/snap"), snap);
    file.setValue(QStringLiteral("tools/loupe_magnification"), loupe_magnification);
    file.setValue(QStringLiteral("tools/parallax_near_m"), parallax_near_m);
    file.setValue(QStringLiteral("tools/parallax_far_m"), parallax_far_m);
    file.setValue(QStringLiteral("tools/depth_near_m"), orNothing(depth.near_m));
    file.setValue(QStringLiteral("tools/depth_far_m"), orNothing(depth.far_m));
}

}  // namespace pmts::app
