#pragma once

#include "pmts/camera/rig.hpp"
#include "pmts/core/result.hpp"
#include "pmts/targeting/thesis_methods.hpp"

#include <QByteArray>
#include <QString>

#include <optional>

namespace pmts::app {

/// A camera on an instrument with the name the surveyor gave it. Kept as JSON: lengths in m, angles in gon, lens in px.
struct RigProfile {
    QString name;
    camera::Rig rig;
    /// Measured with this camera as the thesis does (Tools > Measure APA); absent until somebody did.
    std::optional<targeting::AveragePixelAngle> average_pixel_angle{};
};

/// What a careful calibration of the simulated camera would find: the rig of the first start.
[[nodiscard]] RigProfile simulatedRigProfile();

[[nodiscard]] QByteArray rigProfileToJson(const RigProfile& profile);
/// kBadInput with the field that is missing or out of range.
[[nodiscard]] core::Result<RigProfile> rigProfileFromJson(const QByteArray& json);
[[nodiscard]] core::Result<RigProfile> loadRigProfile(const QString& path);
[[nodiscard]] core::Result<void> saveRigProfile(const RigProfile& profile, const QString& path);

}  // namespace pmts::app
