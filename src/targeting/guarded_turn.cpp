#include "guarded_turn.hpp"

namespace pmts::targeting {

using core::Result;
using geometry::Pointing;

core::Task<Result<Pointing>> guardedTurn(instrument::TotalStation& station,
                                         std::function<Result<void>(const Pointing& target)> may_turn, Pointing target,
                                         core::Angle tolerance, std::stop_token stop) {
    if (may_turn) {
        PMTS_CO_TRY(may_turn(target));
    }
    if (stop.stop_requested()) {
        co_return core::cancelled();
    }
    auto arrived = co_await station.turnTo(target, tolerance, stop);
    if (arrived && stop.stop_requested()) {
        co_return core::cancelled();
    }
    co_return arrived;
}

}  // namespace pmts::targeting
