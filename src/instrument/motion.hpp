#pragma once

#include "exchange.hpp"

namespace pmts::instrument {

struct TurnTarget {
    std::optional<core::Angle> ha, va;
    core::Angle tolerance;
};

[[nodiscard]] core::Task<core::Result<geometry::Pointing>> turn(StatePtr state, TurnTarget target,
                                                                std::stop_token stop);

/// Time the motors need for this way: accelerate, cruise, brake, settle.
[[nodiscard]] core::Duration motionTime(const GeodimeterSettings& settings, core::Angle way);
/// A target outside the motion limits, as an error; nullopt when it may be turned to.
[[nodiscard]] std::optional<core::Error> outsideLimits(const GeodimeterSettings& settings,
                                                       const TurnTarget& target);

}  // namespace pmts::instrument
