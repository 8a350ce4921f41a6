#include "pmts/app/settings/preferences.hpp"

#include <algorithm>
#include <utility>

namespace pmts::app {

namespace {

constexpr std::chrono::milliseconds kSaveAfter{1000};
constexpr std::size_t kChecksKept = 50;

/// A new calibration may only replace one of the same camera in the same mode, focus and zoom.
RigProfile* profileToReplace(Settings& settings, const CameraUse& use) {
    const auto isIts = [&use](const RigProfile& profile) {
        return profile.use && fitnessOf(profile, use) == RigFitness::kFits && profile.use->camera == use.camera;
    };
    const auto found = std::find_if(settings.rig_profiles.begin(), settings.rig_profiles.end(), isIts);
    return found == settings.rig_profiles.end() ? nullptr : &*found;
}

/// What a new profile is compared with: the rig that was in use until now.
RigProfile newProfile(const Settings& settings, const CalibrationRecord& record) {
    const RigProfile before = settings.rigFor(record.camera).profile;
    return {.name = freeProfileName(settings.rig_profiles, record.camera),
            .rig = before.rig,
            .average_pixel_angle = {},
            .use = record.camera,
            .calibration = before.calibration};
}

}  // namespace

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

QString Preferences::acceptRig(const camera::Rig& rig, const CalibrationRecord& record) {
    Settings next = settings_;
    CalibrationRecord kept = record;
    if (kept.camera.size.isEmpty()) {
        kept.camera.size = QSize(rig.width_px, rig.height_px);
    }
    RigProfile* profile = profileToReplace(next, kept.camera);
    if (!profile) {
        next.rig_profiles.push_back(newProfile(next, kept));
        profile = &next.rig_profiles.back();
    }
    profile->previous = EarlierRig{.rig = profile->rig, .calibration = profile->calibration};
    profile->rig = rig;
    profile->use = kept.camera;
    profile->calibration = kept;
    profile->knock_sign.clear();
    const QString name = profile->name;
    if (!kept.camera.isSimulated() || !next.pick_rig) {
        next.rig_profile = name;
    }
    keep(std::move(next));
    return name;
}

template <class Change>
bool Preferences::changeProfile(const QString& name, Change change) {
    Settings next = settings_;
    const auto found = std::find_if(next.rig_profiles.begin(), next.rig_profiles.end(),
                                    [&name](const RigProfile& profile) { return profile.name == name; });
    if (found == next.rig_profiles.end() || !change(*found)) {
        return false;
    }
    keep(std::move(next));
    return true;
}

bool Preferences::goBackToPreviousRig(const QString& profile) {
    return changeProfile(profile, [](RigProfile& of) {
        if (!of.previous) {
            return false;
        }
        std::swap(of.rig, of.previous->rig);
        std::swap(of.calibration, of.previous->calibration);
        of.knock_sign.clear();
        return true;
    });
}

void Preferences::keepCheck(const QString& profile, const RigCheck& check) {
    changeProfile(profile, [&check](RigProfile& of) {
        of.checks.push_back(check);
        if (of.checks.size() > kChecksKept) {
            of.checks.erase(of.checks.begin());
        }
        of.knock_sign = check.passed ? QString() : tr("The last check failed.");
        return true;
    });
}

void Preferences::setKnockSign(const QString& profile, const QString& sentence) {
    changeProfile(profile, [&sentence](RigProfile& of) { return std::exchange(of.knock_sign, sentence) != sentence; });
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
