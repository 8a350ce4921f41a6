#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/core/task.hpp"
#include "pmts/geometry/pointing.hpp"
#include "pmts/protocol/command.hpp"
#include "pmts/protocol/units.hpp"

#include <QDateTime>
#include <QMetaType>
#include <QString>

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace pmts::instrument {

using protocol::EdmMode;

/// What the instrument said about itself at connect.
struct Identity {
    QString model;
    QString serial_number;  ///< label 55
    protocol::WireUnits units;
    bool units_known = true;  ///< false: label 23 could not be read and the profile names no unit; no angle is believed
    std::optional<char> end_mark = '>';
};

/// A slope distance with the circle readings that belong to it. Raw: as the instrument gave it.
struct DistanceShot {
    geometry::Pointing pointing;
    double slope_distance_m = 0.0;
    EdmMode mode = EdmMode::kStd;
    core::Duration time_taken{0};  ///< TT (thesis 8.4.2)
    core::Duration measured_at{0};
    QDateTime utc;
    QString raw_reply;
};

/// A block nobody asked for: the operator pressed REG, or slave mode (protocol page 2.8). Absent what it did not hold.
struct UnsolicitedBlock {
    std::optional<core::Angle> ha, va;
    std::optional<double> slope_distance_m;
    std::optional<double> n_m, e_m, h_m;
    QString point_number;
    QString point_code;
    QString raw;
};

enum class Activity { kIdle, kConnecting, kTurning, kMeasuring, kReading };

/// What the instrument is busy with: shown after 300 ms, with the usual time after 2 s.
struct Progress {
    Activity activity = Activity::kIdle;
    double fraction = 0.0;              ///< 0..1, from the learned speed or L
    core::Duration elapsed{0};
    std::optional<core::Duration> usual;
};

/// A robotic total station, whatever its protocol. Lives on the instrument thread; one routine at a time, except stop().
/// Angles are circle readings (orientation is the survey room's business).
class TotalStation {
public:
    virtual ~TotalStation() = default;

    [[nodiscard]] virtual core::Task<core::Result<Identity>> connectTo(std::stop_token stop) = 0;
    [[nodiscard]] virtual core::Task<core::Result<geometry::Pointing>> readPointing(std::stop_token stop) = 0;
    /// Turns and verifies the arrival against the circles; kNotReached with the residual in the sentence, kLimit, kDevice.
    [[nodiscard]] virtual core::Task<core::Result<geometry::Pointing>> turnTo(geometry::Pointing target, core::Angle tolerance,
                                                                              std::stop_token stop) = 0;
    [[nodiscard]] virtual core::Task<core::Result<geometry::Pointing>> turnHorizontal(core::Angle ha, core::Angle tolerance,
                                                                                      std::stop_token stop) = 0;
    [[nodiscard]] virtual core::Task<core::Result<geometry::Pointing>> turnVertical(core::Angle va, core::Angle tolerance,
                                                                                    std::stop_token stop) = 0;
    /// Wait and terminate: past the learned limit the shot is cancelled in the instrument; kAbsurdPoint.
    [[nodiscard]] virtual core::Task<core::Result<DistanceShot>> measureDistance(std::stop_token stop) = 0;
    [[nodiscard]] virtual core::Task<core::Result<void>> setMode(EdmMode mode) = 0;
    [[nodiscard]] virtual EdmMode mode() const = 0;
    [[nodiscard]] virtual core::Task<core::Result<bool>> testSignal(std::stop_token stop) = 0;
    [[nodiscard]] virtual core::Task<core::Result<QString>> get(int label, std::stop_token stop) = 0;
    /// Writes and reads back (features C2).
    [[nodiscard]] virtual core::Task<core::Result<void>> set(int label, QString data, std::stop_token stop) = 0;
    /// On the wire at once, whatever runs; the running routine completes with kCancelled.
    virtual void stop() = 0;

    std::function<void(const geometry::Pointing&, core::Duration measured_at)> on_pointing;  ///< every reading, polls included
    std::function<void(const Progress&)> on_progress;
    std::function<void(const UnsolicitedBlock&)> on_unsolicited;
    /// All that the instrument warns of while it goes on working (battery low), told at every change; empty: over.
    std::function<void(const std::vector<core::Error>&)> on_warnings;
    std::function<void(const core::Error&)> on_lost;
};

}  // namespace pmts::instrument
