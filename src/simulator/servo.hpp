#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/simulator/station_settings.hpp"
#include "pmts/simulator/world.hpp"

#include <functional>
#include <memory>

namespace pmts::simulator {

/// The two motors. They know the true pointing only; what the circles show is the station's business.
class Servo {
public:
    Servo(const StationSettings& settings, core::Clock& clock, std::shared_ptr<TruePointing> pointing);

    /// Turns both axes at once, HA the short way round, VA through the zenith. `done` runs when both have
    /// settled.
    void turnTo(const geometry::Pointing& true_target, std::function<void()> done);
    /// The same, but the axes stop half way.
    void turnHalfWayTo(const geometry::Pointing& true_target, std::function<void()> done);
    /// Brakes; `done` of the broken motion never runs.
    void stop();
    [[nodiscard]] bool isTurning() const { return turning_; }

private:
    void turn(const geometry::Pointing& true_target, double part, std::function<void()> done);

    const StationSettings& settings_;
    core::Clock& clock_;
    std::shared_ptr<TruePointing> pointing_;
    bool turning_ = false;
    core::Timer timer_;
};

}  // namespace pmts::simulator
