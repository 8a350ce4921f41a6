#include "pmts/app/field/range_keeper.hpp"

#include "pmts/geometry/polar.hpp"

namespace pmts::app {

namespace {
/// The instrument's own idea of "the same target": its old-distance guard.
constexpr core::Angle kSameTarget = core::Angle::fromMgon(50);
constexpr double kFarthest_m = 5000.0;  ///< a plane met farther away is met by accident
}  // namespace

RangeKeeper::RangeKeeper(double assumed_m, QObject* parent) : QObject(parent), assumed_m_(assumed_m) {}

RangeAssumption RangeKeeper::rangeAt(const std::optional<geometry::Pointing>& pointing) const {
    const bool is_here = last_shot_ && pointing && geometry::separation(*pointing, last_shot_->pointing) <= kSameTarget;
    if (is_here) {
        return {.slope_distance_m = last_shot_->slope_distance_m, .source = RangeSource::kMeasured};
    }
    return pointing ? rangeAlong(geometry::lineOfSight(*pointing), std::nullopt) : usual();
}

RangeAssumption RangeKeeper::rangeAlong(const geometry::Ray& ray, const std::optional<geometry::Pointing>& pointing) const {
    if (plane_) {
        if (const auto p_station = geometry::intersect(ray, *plane_); p_station && p_station->norm() <= kFarthest_m) {
            return {.slope_distance_m = p_station->norm(), .source = RangeSource::kPlane};
        }
    }
    return pointing ? rangeAt(pointing) : usual();
}

RangeAssumption RangeKeeper::usual() const {
    return last_shot_ ? RangeAssumption{.slope_distance_m = last_shot_->slope_distance_m, .source = RangeSource::kLastShot}
                      : RangeAssumption{.slope_distance_m = assumed_m_, .source = RangeSource::kAssumed};
}

void RangeKeeper::setPlane(const std::optional<geometry::Plane>& plane) {
    plane_ = plane;
    Q_EMIT changed();
}

void RangeKeeper::setAssumed(double range_m) {
    assumed_m_ = range_m;
    Q_EMIT changed();
}

void RangeKeeper::addShot(const geometry::Pointing& pointing, double slope_distance_m) {
    last_shot_ = Shot{.pointing = pointing, .slope_distance_m = slope_distance_m};
    Q_EMIT changed();
}

void RangeKeeper::forgetAll() {
    last_shot_.reset();
    plane_.reset();
    Q_EMIT changed();
}

}  // namespace pmts::app
