#include "pmts/app/settings/black_box_settings.hpp"

#include "setting_values.hpp"

namespace pmts::app {

void BlackBoxSettings::load(const QSettings& file) {
    on = file.value(QStringLiteral("black_box/on"), on).toBool();
    kept_mb = static_cast<int>(numberFrom(file, "black_box/kept_mb", kept_mb, 20, 20000));
    frames_per_s = numberFrom(file, "black_box/frames_per_s", frames_per_s, 0.0, 10.0);
}

void BlackBoxSettings::save(QSettings& file) const {
    file.setValue(QStringLiteral("black_box/on"), on);
    file.setValue(QStringLiteral("black_box/kept_mb"), kept_mb);
    file.setValue(QStringLiteral("black_box/frames_per_s"), frames_per_s);
}

}  // namespace pmts::app
