#pragma once

#include "exchange.hpp"

namespace pmts::instrument {

[[nodiscard]] core::Task<core::Result<DistanceShot>> measure(StatePtr state, std::stop_token stop);
/// Selects the mode in the instrument; a running measurement ends and its distance is gone.
[[nodiscard]] core::Task<core::Result<void>> selectMode(StatePtr state, EdmMode mode, std::stop_token stop);

/// Whether a distance may belong to another point: the pointing moved more than 50 mgon, or more than 30 cm
/// at the target, the latter in proportion beyond 400 m (target data test, protocol page 4.5).
[[nodiscard]] bool isOtherPoint(const GeodimeterSettings& settings, const geometry::Pointing& before,
                                const geometry::Pointing& after, double slope_distance_m);

}  // namespace pmts::instrument
