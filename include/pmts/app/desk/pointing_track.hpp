#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/geometry/pointing.hpp"

#include <QMetaType>

#include <deque>
#include <optional>

namespace pmts::app {

/// A reading of the circles and when it was true.
struct TimedPointing {
    geometry::Pointing pointing;
    core::Duration at{0};
};

/// Where the telescope pointed at a moment, from the readings around it.
struct TrackedPointing {
    geometry::Pointing pointing;
    bool moving = false;   ///< the readings around it differ by more than kStill: do not measure in such a frame
    bool settled = false;  ///< a reading after the moment says the same as one before it
};

/// The recent circle readings. Frames get their HA/VA from here by time: between two readings linear, the short way round.
class PointingTrack {
public:
    static constexpr core::Duration kKept = std::chrono::seconds(3);
    static constexpr core::Angle kStill = core::Angle::fromMgon(5);

    void add(const TimedPointing& reading);
    void clear() { readings_.clear(); }
    [[nodiscard]] std::optional<TrackedPointing> at(core::Duration time) const;
    [[nodiscard]] std::optional<TimedPointing> newest() const;

private:
    std::deque<TimedPointing> readings_;
};

}  // namespace pmts::app
