#pragma once

#include "pmts/app/settings/aiming_settings.hpp"
#include "pmts/app/settings/black_box_settings.hpp"
#include "pmts/app/settings/camera_settings.hpp"
#include "pmts/app/settings/control_settings.hpp"
#include "pmts/app/settings/image_tool_settings.hpp"
#include "pmts/app/settings/instrument_care_settings.hpp"
#include "pmts/app/settings/rig_care_settings.hpp"
#include "pmts/app/lab/rig_choice.hpp"
#include "pmts/app/lab/rig_profile.hpp"
#include "pmts/app/desk/serial_choice.hpp"
#include "pmts/app/settings/unit_format.hpp"
#include "pmts/instrument/total_station.hpp"
#include "pmts/video/video_source.hpp"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace pmts::app {

enum class Palette { kDay, kNight, kSun };
/// Blocks nobody asked for (REG key, slave mode): what becomes of them.
enum class UnsolicitedPolicy { kOffer, kRecord, kIgnore };
enum class LastDevice { kSimulated, kSerial };

/// Everything PMTS remembers between two starts. A value; file format: QSettings INI.
struct Settings {
    UnitFormat units;
    Palette palette = Palette::kDay;
    QByteArray window_geometry;  ///< opaque, the gui's
    QByteArray window_layout;    ///< opaque, the gui's
    QString last_job;
    LastDevice last_device = LastDevice::kSimulated;
    SerialChoice serial;
    ControlSettings control;
    video::SourceAddress camera;
    CameraSettings cameras;
    core::Angle arrow_step = core::Angle::fromArcsec(300);  ///< 5'
    instrument::EdmMode edm_mode = instrument::EdmMode::kStd;
    double assumed_range_m = 25.0;
    double target_height_m = 0.0;
    core::Angle turn_tolerance = core::Angle::fromCc(5);
    AimingSettings aiming;
    UnsolicitedPolicy unsolicited = UnsolicitedPolicy::kOffer;
    bool sounds = true;
    ImageToolSettings image_tools;
    QStringList recent_codes;  ///< most used first
    QStringList recent_jobs;   ///< newest first
    std::vector<RigProfile> rig_profiles;
    QString rig_profile;       ///< name of the chosen one
    RigCareSettings rig_care;
    BlackBoxSettings black_box;
    InstrumentCareSettings instrument_care;
    bool pick_rig = true;      ///< the program picks the profile that fits the camera; else the chosen one is used
    /// Of the simulated camera, which is not among the profiles; read it through chosenRig().
    std::optional<targeting::AveragePixelAngle> simulated_pixel_angle;

    /// Missing or unreadable entries keep their default: a damaged settings file never stops the start.
    [[nodiscard]] static Settings load(const QString& path);
    /// kFile when it cannot be written.
    [[nodiscard]] core::Result<void> save(const QString& path) const;
    /// The chosen rig, or the simulated camera's.
    [[nodiscard]] RigProfile chosenRig() const;
    /// The rig pictures of this camera are aimed with; scaled to its size where no other fits.
    [[nodiscard]] RigChoice rigFor(const CameraUse& now) const;
    [[nodiscard]] RigProfile rigOf(video::SourceKind kind) const;
    [[nodiscard]] const RigProfile* profileNamed(const QString& name) const;  ///< null: no such profile
    /// Keeps it with the chosen rig.
    void setAveragePixelAngle(const std::optional<targeting::AveragePixelAngle>& angle);
};

}  // namespace pmts::app
