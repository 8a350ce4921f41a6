#include "pmts/app/range_keeper.hpp"

#include "pmts/geometry/polar.hpp"

namespace pmts::app {

namespace {
/// The instrument's own idea of "the same target": its old-distance guard.
constexpr core::Angle kSameTarget = core::Angle::fromMgon(50);
}  // namespace

RangeKeeper::RangeKeeper(double assumed_m, QObject* parent) : QObject(parent), assumed_m_(assumed_m) {}

RangeAssumption RangeKeeper::rangeAt(const std::optional<geometry::Pointing>& pointing) const {
    if (!last_shot_) {
        return {.slope_distance_m = assumed_m_, .source = RangeSource::kAssumed};
    }
    const bool here = pointing && geometry::separation(*pointing, last_shot_->pointing) <= kSameTarget;
    return {.slope_distance_m = last_shot_->slope_distance_m,
            .source = here ? RangeSource::kMeasured : RangeSource::kLastShot};
}

void RangeKeeper::setAssumed(double range_m) {
    assumed_m_ = range_m;
    Q_EMIT changed();
}

void RangeKeeper::addShot(const geometry::Pointing& pointing, double slope_distance_m) {
    last_shot_ = Shot{.pointing = pointing, .slope_distance_m = slope_distance_m};
    Q_EMIT changed();
}

void RangeKeeper::forgetShots() {
    last_shot_.reset();
    Q_EMIT changed();
}

}  // namespace pmts::app
