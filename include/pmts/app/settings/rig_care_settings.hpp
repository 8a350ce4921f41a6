#pragma once

#include "pmts/calibration/board.hpp"
#include "pmts/core/angle.hpp"

#include <optional>

class QSettings;

namespace pmts::app {

/// When a calibration is no longer trusted, and how it is checked; a part of Settings.
struct RigCareSettings {
    int age_limit_days = 30;
    double temperature_limit_c = 15.0;  ///< away from the temperature of the calibration
    double check_limit_px = 1.5;        ///< rms of the one-minute check
    core::Angle check_limit = core::Angle::fromGon(0.070);
    double knock_limit_px = 4.0;        ///< median of what the first moves of clicks leave over
    int knock_moves = 5;                ///< of that many clicked moves
    calibration::BoardPattern board;    ///< that was used last

    /// Missing or unreadable entries keep their default.
    void load(const QSettings& file);
    void save(QSettings& file) const;
};

}  // namespace pmts::app
