#include "pmts/app/settings/settings.hpp"

#include "desk/serial_keeping.hpp"
#include "setting_values.hpp"

#include <QCoreApplication>
#include <QSettings>

#include <algorithm>
#include <cmath>

namespace pmts::app {

namespace {

const QString kSerial = QStringLiteral("serial/");

void loadUnits(const QSettings& file, UnitFormat& units) {
    units.angle_unit = enumFrom(file, "units/angle", units.angle_unit, static_cast<int>(core::AngleUnit::kMil));
    units.length_unit = enumFrom(file, "units/length", units.length_unit, static_cast<int>(core::LengthUnit::kFoot));
    units.length_decimals = static_cast<int>(numberFrom(file, "units/length_decimals", units.length_decimals, 0, 4));
}

void loadWork(const QSettings& file, Settings& s) {
    s.arrow_step = core::Angle::fromGon(numberFrom(file, "work/arrow_step_gon", s.arrow_step.gon(), 1e-4, 100.0));
    s.edm_mode = enumFrom(file, "work/edm_mode", s.edm_mode, 4);
    s.assumed_range_m = numberFrom(file, "work/assumed_range_m", s.assumed_range_m, 0.5, 5000.0);
    s.target_height_m = numberFrom(file, "work/target_height_m", s.target_height_m, -100.0, 100.0);
    s.turn_tolerance = core::Angle::fromCc(numberFrom(file, "work/turn_tolerance_cc", s.turn_tolerance.cc(), 0, 99));
    s.unsolicited = enumFrom(file, "work/unsolicited", s.unsolicited, static_cast<int>(UnsolicitedPolicy::kIgnore));
    s.recent_codes = file.value(QStringLiteral("work/recent_codes")).toStringList();
}

void loadRigs(const QSettings& file, Settings& s) {
    for (const QString& json : file.value(QStringLiteral("rigs/profiles")).toStringList()) {
        if (auto profile = rigProfileFromJson(json.toUtf8())) {
            s.rig_profiles.push_back(*std::move(profile));
        }
    }
    s.rig_profile = file.value(QStringLiteral("rigs/chosen")).toString();
    s.pick_rig = file.value(QStringLiteral("rigs/pick"), s.pick_rig).toBool();
    const double across_gon = file.value(QStringLiteral("rigs/simulated_apa_across_gon")).toDouble();
    const double down_gon = file.value(QStringLiteral("rigs/simulated_apa_down_gon")).toDouble();
    if (std::isnormal(across_gon) && std::isnormal(down_gon)) {
        s.simulated_pixel_angle = {core::Angle::fromGon(across_gon), core::Angle::fromGon(down_gon)};
    }
}

void saveUnitsAndWork(QSettings& file, const Settings& s) {
    file.setValue(QStringLiteral("units/angle"), static_cast<int>(s.units.angle_unit));
    file.setValue(QStringLiteral("units/length"), static_cast<int>(s.units.length_unit));
    file.setValue(QStringLiteral("units/length_decimals"), s.units.length_decimals);
    file.setValue(QStringLiteral("work/arrow_step_gon"), s.arrow_step.gon());
    file.setValue(QStringLiteral("work/edm_mode"), static_cast<int>(s.edm_mode));
    file.setValue(QStringLiteral("work/assumed_range_m"), s.assumed_range_m);
    file.setValue(QStringLiteral("work/target_height_m"), s.target_height_m);
    file.setValue(QStringLiteral("work/turn_tolerance_cc"), s.turn_tolerance.cc());
    file.setValue(QStringLiteral("work/unsolicited"), static_cast<int>(s.unsolicited));
    file.setValue(QStringLiteral("work/recent_codes"), s.recent_codes);
}

void saveDevices(QSettings& file, const Settings& s) {
    file.setValue(QStringLiteral("devices/last"), static_cast<int>(s.last_device));
    saveSerial(file, kSerial, s.serial);
    file.setValue(QStringLiteral("camera/kind"), static_cast<int>(s.camera.kind));
    file.setValue(QStringLiteral("camera/location"), s.camera.location);
    file.setValue(QStringLiteral("camera/name"), s.camera.name);
    QStringList profiles;
    for (const RigProfile& profile : s.rig_profiles) {
        profiles.append(QString::fromUtf8(rigProfileToJson(profile)));
    }
    file.setValue(QStringLiteral("rigs/profiles"), profiles);
    file.setValue(QStringLiteral("rigs/chosen"), s.rig_profile);
    file.setValue(QStringLiteral("rigs/pick"), s.pick_rig);
    const auto gon = [](const auto& angle, auto part) { return angle ? QVariant(((*angle).*part).gon()) : QVariant(); };
    file.setValue(QStringLiteral("rigs/simulated_apa_across_gon"),
                  gon(s.simulated_pixel_angle, &targeting::AveragePixelAngle::horizontal));
    file.setValue(QStringLiteral("rigs/simulated_apa_down_gon"),
                  gon(s.simulated_pixel_angle, &targeting::AveragePixelAngle::vertical));
}

}  // namespace

Settings Settings::load(const QString& path) {
    const QSettings file(path, QSettings::IniFormat);
    Settings s;
    loadUnits(file, s.units);
    s.serial = serialFrom(file, kSerial);
    loadWork(file, s);
    loadRigs(file, s);
    s.aiming.load(file);
    s.image_tools.load(file);
    s.cameras.load(file);
    s.control.load(file);
    s.black_box.load(file);
    s.rig_care.load(file);
    s.instrument_care.load(file);
    s.palette = enumFrom(file, "window/palette", s.palette, static_cast<int>(Palette::kSun));
    s.window_geometry = file.value(QStringLiteral("window/geometry")).toByteArray();
    s.window_layout = file.value(QStringLiteral("window/layout")).toByteArray();
    s.sounds = file.value(QStringLiteral("window/sounds"), s.sounds).toBool();
    s.last_job = file.value(QStringLiteral("job/last")).toString();
    s.recent_jobs = file.value(QStringLiteral("job/recent")).toStringList();
    s.last_device = enumFrom(file, "devices/last", s.last_device, static_cast<int>(LastDevice::kSerial));
    s.camera.kind = enumFrom(file, "camera/kind", s.camera.kind, static_cast<int>(video::SourceKind::kStream));
    s.camera.location = file.value(QStringLiteral("camera/location")).toString();
    s.camera.name = file.value(QStringLiteral("camera/name")).toString();
    return s;
}

core::Result<void> Settings::save(const QString& path) const {
    QSettings file(path, QSettings::IniFormat);
    saveUnitsAndWork(file, *this);
    saveDevices(file, *this);
    aiming.save(file);
    image_tools.save(file);
    cameras.save(file);
    control.save(file);
    black_box.save(file);
    rig_care.save(file);
    instrument_care.save(file);
    file.setValue(QStringLiteral("window/palette"), static_cast<int>(palette));
    file.setValue(QStringLiteral("window/geometry"), window_geometry);
    file.setValue(QStringLiteral("window/layout"), window_layout);
    file.setValue(QStringLiteral("window/sounds"), sounds);
    file.setValue(QStringLiteral("job/last"), last_job);
    file.setValue(QStringLiteral("job/recent"), recent_jobs);
    file.sync();
    if (file.status() != QSettings::NoError) {
        return core::fail(core::ErrorKind::kFile, QCoreApplication::translate("Settings", "The settings cannot be kept."),
                          QCoreApplication::translate("Settings", "Check that the settings folder can be written."), path);
    }
    return {};
}

const RigProfile* Settings::profileNamed(const QString& name) const {
    const auto found = std::find_if(rig_profiles.begin(), rig_profiles.end(),
                                    [&name](const RigProfile& profile) { return profile.name == name; });
    return found == rig_profiles.end() ? nullptr : &*found;
}

RigProfile Settings::chosenRig() const {
    const RigProfile* const chosen = profileNamed(rig_profile);
    return chosen ? *chosen : rigOf(video::SourceKind::kSimulated);
}

void Settings::setAveragePixelAngle(const std::optional<targeting::AveragePixelAngle>& angle) {
    const auto found = std::find_if(rig_profiles.begin(), rig_profiles.end(),
                                    [this](const RigProfile& profile) { return profile.name == rig_profile; });
    (found != rig_profiles.end() ? found->average_pixel_angle : simulated_pixel_angle) = angle;
}

RigChoice Settings::rigFor(const CameraUse& now) const {
    RigChoice choice = pickRig(rig_profiles, rig_profile, pick_rig, now);
    if (now.isSimulated() && !choice.profile.average_pixel_angle) {
        choice.profile.average_pixel_angle = simulated_pixel_angle;
    }
    return choice;
}

RigProfile Settings::rigOf(video::SourceKind kind) const {
    CameraUse now;
    now.source = kind;
    return rigFor(now).profile;
}

}  // namespace pmts::app
