#include "pmts/app/preferences.hpp"

namespace pmts::app {

namespace {
constexpr std::chrono::milliseconds kSaveAfter{1000};
}

Preferences::Preferences(QString path, QObject* parent)
    : QObject(parent), path_(std::move(path)), settings_(path_.isEmpty() ? Settings{} : Settings::load(path_)) {
    save_soon_.setSingleShot(true);
    save_soon_.setInterval(kSaveAfter);
    connect(&save_soon_, &QTimer::timeout, this, &Preferences::save);
}

Preferences::~Preferences() {
    if (save_soon_.isActive()) {
        save();
    }
}

void Preferences::keep(Settings next) {
    const bool units_changed = !(next.units == settings_.units);
    const bool palette_changed = next.palette != settings_.palette;
    settings_ = std::move(next);
    if (!path_.isEmpty()) {
        save_soon_.start();
    }
    if (units_changed) {
        Q_EMIT unitsChanged(settings_.units);
    }
    if (palette_changed) {
        Q_EMIT paletteChanged(settings_.palette);
    }
    Q_EMIT changed();
}

template <class Change>
void Preferences::change(Change change) {
    Settings next = settings_;
    change(next);
    keep(std::move(next));
}

void Preferences::set(const Settings& settings) { keep(settings); }

void Preferences::setUnits(const UnitFormat& units) {
    change([&](Settings& next) { next.units = units; });
}

void Preferences::setPalette(Palette palette) {
    change([&](Settings& next) { next.palette = palette; });
}

void Preferences::setWindow(const QByteArray& geometry, const QByteArray& layout) {
    change([&](Settings& next) {
        next.window_geometry = geometry;
        next.window_layout = layout;
    });
}

void Preferences::setSounds(bool on) {
    change([&](Settings& next) { next.sounds = on; });
}

void Preferences::setUnsolicitedPolicy(UnsolicitedPolicy policy) {
    change([&](Settings& next) { next.unsolicited = policy; });
}

void Preferences::setAveragePixelAngle(const targeting::AveragePixelAngle& angle) {
    Settings next = settings_;
    next.setAveragePixelAngle(angle);
    keep(std::move(next));
}

void Preferences::save() {
    save_soon_.stop();
    if (path_.isEmpty()) {
        return;
    }
    if (const auto saved = settings_.save(path_); !saved) {
        Q_EMIT problemReported(saved.error());
    }
}

}  // namespace pmts::app
