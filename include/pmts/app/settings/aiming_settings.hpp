#pragma once

#include "pmts/targeting/method_report.hpp"
#include "pmts/targeting/pointing_guard.hpp"
#include "pmts/targeting/recentring.hpp"

#include <QSettings>

#include <optional>

namespace pmts::app {

/// How a click becomes a pointing, how well it must be reached, and where the instrument must not point.
struct AimingSettings {
    targeting::Method method = targeting::Method::kRigorous;
    bool recentre = true;       ///< find the clicked spot again after the move and turn until it is on the reticle
    bool click_turns = false;   ///< one click turns at once; else it shows HA and VA and Move turns
    double tolerance_px = 0.1;  ///< settled when either of the two holds
    core::Angle tolerance = core::Angle::fromArcsec(20);

    targeting::MotionLimits limits;
    bool avoids_sun = false;
    std::optional<targeting::Place> place;  ///< of the station, for the Sun
    core::Angle sun_cone = core::Angle::fromGon(10);
    std::optional<core::Angle> most_wound;  ///< cable; absent: not watched

    [[nodiscard]] targeting::RecentringSettings recentring(core::Angle turn_tolerance) const;
    /// `orientation`: azimuth of circle reading 0 on the station. Without a place the Sun is not watched.
    [[nodiscard]] targeting::PointingGuardSettings guard(core::Angle orientation) const;

    /// What is missing or out of range keeps its default.
    void load(const QSettings& file);
    void save(QSettings& file) const;
};

}  // namespace pmts::app
