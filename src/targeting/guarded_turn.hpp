#pragma once

#include "pmts/instrument/total_station.hpp"

#include <functional>
#include <stop_token>

namespace pmts::targeting {

/// Turns to a target when `may_turn`, where there is one, has nothing against it: its error is the answer then. A stop
/// counts before the turn and after it. The station outlives the task.
[[nodiscard]] core::Task<core::Result<geometry::Pointing>> guardedTurn(
    instrument::TotalStation& station, std::function<core::Result<void>(const geometry::Pointing& target)> may_turn,
    geometry::Pointing target, core::Angle tolerance, std::stop_token stop);

}  // namespace pmts::targeting
