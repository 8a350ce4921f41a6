#include "pmts/app/desk/pointing_track.hpp"

#include <algorithm>
#include <iterator>

namespace pmts::app {

namespace {

bool isStill(const geometry::Pointing& a, const geometry::Pointing& b) {
    return core::abs(core::normalizedSigned(a.ha - b.ha)) <= PointingTrack::kStill &&
           core::abs(core::normalizedSigned(a.va - b.va)) <= PointingTrack::kStill;
}

/// Linear, the short way round.
geometry::Pointing between(const TimedPointing& before, const TimedPointing& after, core::Duration time) {
    const double share = static_cast<double>((time - before.at).count()) / static_cast<double>((after.at - before.at).count());
    const core::Angle turned_ha = core::normalizedSigned(after.pointing.ha - before.pointing.ha);
    const core::Angle turned_va = core::normalizedSigned(after.pointing.va - before.pointing.va);
    return {.ha = core::normalized(before.pointing.ha + turned_ha * share),
            .va = core::normalized(before.pointing.va + turned_va * share)};
}

}  // namespace

void PointingTrack::add(const TimedPointing& reading) {
    if (!readings_.empty() && reading.at <= readings_.back().at) {
        return;  // a late reading of an older moment says nothing new
    }
    readings_.push_back(reading);
    while (readings_.size() > 2 && readings_.front().at < reading.at - kKept) {
        readings_.pop_front();
    }
}

std::optional<TrackedPointing> PointingTrack::at(core::Duration time) const {
    if (readings_.empty()) {
        return std::nullopt;
    }
    const auto after = std::lower_bound(readings_.begin(), readings_.end(), time,
                                        [](const TimedPointing& reading, core::Duration t) { return reading.at < t; });
    if (after == readings_.end()) {
        const bool moved = readings_.size() > 1 && !isStill(std::prev(after, 2)->pointing, readings_.back().pointing);
        return TrackedPointing{.pointing = readings_.back().pointing, .moving = moved, .settled = false};
    }
    if (after == readings_.begin()) {
        return TrackedPointing{.pointing = after->pointing, .moving = false, .settled = after->at == time};
    }
    const auto before = std::prev(after);
    const bool still = isStill(before->pointing, after->pointing);
    return TrackedPointing{.pointing = between(*before, *after, time), .moving = !still, .settled = still};
}

std::optional<TimedPointing> PointingTrack::newest() const {
    return readings_.empty() ? std::nullopt : std::optional(readings_.back());
}

}  // namespace pmts::app
