#pragma once

#include "pmts/targeting/recentring.hpp"

namespace pmts::targeting {

/// A look for a patch after a move.
struct Look {
    Patch patch;
    Expectation expected;
    core::Duration since{0};  ///< of the arrival: only frames exposed later count
    double still_px = 0.25;
    int most_frames = 12;
};

struct SettledMatch {
    Match match;  ///< mean of the last two
    camera::FramePtr frame;
};

/// Finds the patch in frames after the arrival until two in a row agree. kCamera when only old frames come,
/// kNotReached when the picture does not come to rest, or the matcher's error.
[[nodiscard]] core::Task<core::Result<SettledMatch>> settledMatch(Look look, FrameAfter frame_after, FindPatch find,
                                                                  std::stop_token stop);

/// Pixel at `now` of what a pixel showed at `then`, for things `range_m` away.
[[nodiscard]] core::Result<Eigen::Vector2d> carried(const PixelToPointing& model, const Eigen::Vector2d& px,
                                                    const geometry::Pointing& then, const geometry::Pointing& now,
                                                    double range_m);

/// The same for the whole picture, moved on by what is known to be off.
[[nodiscard]] Expectation carriedExpectation(PixelToPointing model, geometry::Pointing then, geometry::Pointing now,
                                             double range_m, Eigen::Vector2d known_off_px, double radius_px);

}  // namespace pmts::targeting
