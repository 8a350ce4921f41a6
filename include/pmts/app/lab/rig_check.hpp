#pragma once

#include "pmts/app/lab/calibration_record.hpp"
#include "pmts/core/angle.hpp"

namespace pmts::app {

/// One check against a known point: what the rig predicts less what the pictures showed, over some pointings.
struct RigCheck {
    QDateTime utc{};
    int pointings = 0;
    double rms_px = 0.0;      ///< over pointings: length of the residual in the picture
    double largest_px = 0.0;
    core::Angle rms{};          ///< the same as angles
    core::Angle largest{};
    double limit_px = 0.0;    ///< that was in force
    core::Angle limit{};
    bool passed = false;
    QString target{};           ///< `point 104`, `a spot`
    std::optional<double> temperature_c{};
    std::vector<RecordedResidual> residuals{};
};

[[nodiscard]] QJsonObject rigCheckToJson(const RigCheck& check);
/// Every entry may be missing.
[[nodiscard]] RigCheck rigCheckFromJson(const QJsonObject& json);

}  // namespace pmts::app
