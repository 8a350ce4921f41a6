#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/geometry/pointing.hpp"

#include <mutex>

namespace pmts::simulator {

/// Motion of one axis: accelerate, cruise, brake; evaluated at any time, so that the camera and the wire
/// agree. Before started_at the axis stands at start_gon, after duration() it stands at end_gon.
struct AxisMotion {
    double start_gon = 0.0;
    double end_gon = 0.0;
    core::Duration started_at{0};
    double speed_gon_s = 50.0;
    double acceleration_gon_s2 = 100.0;
    double start_speed_gon_s = 0.0;  ///< towards the end, >= 0: an axis that was already turning

    [[nodiscard]] double positionGon(core::Duration at) const;
    [[nodiscard]] double speedGonS(core::Duration at) const;  ///< signed
    [[nodiscard]] core::Duration duration() const;
    [[nodiscard]] core::Duration endsAt() const { return started_at + duration(); }
    /// What the axis does when it is told to stop: brakes as hard as it can.
    [[nodiscard]] AxisMotion brakedAt(core::Duration at) const;
};

/// Both axes, in gon. VA counts through the zenith: -100 is VA 300 gon, face II.
struct AxisMotions {
    AxisMotion ha{};
    AxisMotion va{.start_gon = 100.0, .end_gon = 100.0};
};

/// The true pointing of the simulated instrument over time: written by the station's thread, read by the
/// camera's. Locked inside.
class TruePointing {
public:
    /// HA and VA in [0, 400) gon; VA above 200 gon is face II.
    [[nodiscard]] geometry::Pointing at(core::Duration time) const;
    [[nodiscard]] AxisMotions motions() const;
    void setMotion(const AxisMotion& ha, const AxisMotion& va);
    /// Stands still at this pointing, at once.
    void place(const geometry::Pointing& pointing);

private:
    mutable std::mutex mutex_;
    AxisMotions motions_;
};

}  // namespace pmts::simulator
