#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/geometry/pointing.hpp"

#include <mutex>

namespace pmts::simulator {

/// Motion of one axis: accelerate, cruise, brake; evaluated at any time, so that the camera and the wire agree.
struct AxisMotion {
    double start_gon = 0.0;
    double end_gon = 0.0;
    core::Duration started_at{0};
    double speed_gon_s = 50.0;
    double acceleration_gon_s2 = 100.0;

    [[nodiscard]] double positionGon(core::Duration at) const;
    [[nodiscard]] core::Duration duration() const;
};

/// The true pointing of the simulated instrument over time: written by the station's thread, read by the camera's. Locked inside.
class TruePointing {
public:
    [[nodiscard]] geometry::Pointing at(core::Duration time) const;
    void setMotion(const AxisMotion& ha, const AxisMotion& va);

private:
    mutable std::mutex mutex_;
    AxisMotion ha_{};
    AxisMotion va_{.start_gon = 100.0, .end_gon = 100.0};
};

}  // namespace pmts::simulator
