#pragma once

#include "pmts/app/lab/calibration_record.hpp"
#include "pmts/app/lab/rig_check.hpp"
#include "pmts/camera/rig.hpp"
#include "pmts/core/result.hpp"
#include "pmts/targeting/thesis_methods.hpp"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace pmts::app {

/// A rig that was in use before, kept to compare with and to go back to.
struct EarlierRig {
    camera::Rig rig;
    std::optional<CalibrationRecord> calibration;
};

/// A camera on an instrument with the name the surveyor gave it. Kept as JSON: lengths in m, angles in gon, lens in px.
struct RigProfile {
    QString name;
    camera::Rig rig;
    /// Measured with this camera as the thesis does (Tools > Measure APA); absent until somebody did.
    std::optional<targeting::AveragePixelAngle> average_pixel_angle{};
    /// The camera and mode it belongs to; absent in profiles that nobody calibrated: they are used when chosen by hand.
    std::optional<CameraUse> use{};
    std::optional<CalibrationRecord> calibration{};
    std::optional<EarlierRig> previous{};
    std::vector<RigCheck> checks{};  ///< oldest first
    /// Why the camera seems to have been knocked since; empty when nothing says so. A passed check or a new calibration clears it.
    QString knock_sign{};
};

/// What a careful calibration of the simulated camera would find: the rig of the first start.
[[nodiscard]] RigProfile simulatedRigProfile();

[[nodiscard]] QByteArray rigProfileToJson(const RigProfile& profile);
/// kBadInput with the field that is missing or out of range.
[[nodiscard]] core::Result<RigProfile> rigProfileFromJson(const QByteArray& json);
[[nodiscard]] core::Result<RigProfile> loadRigProfile(const QString& path);
[[nodiscard]] core::Result<void> saveRigProfile(const RigProfile& profile, const QString& path);

}  // namespace pmts::app
