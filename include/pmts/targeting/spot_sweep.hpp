#pragma once

#include "pmts/targeting/recentring.hpp"

#include <vector>

namespace pmts::targeting {

struct SweepSettings {
    core::Angle turn_tolerance = core::Angle::fromCc(5);
    double search_radius_px = 60.0;  ///< around the place the nearest sighting promises
    double still_px = 0.25;          ///< two frames in a row agree: nothing swings any more
    int most_frames = 12;            ///< awaited at each pointing for that
    int most_misses = 6;             ///< in a row; then the sweep gives up
    bool come_back = true;           ///< ends where it began
};

/// A spot seen from one of the pointings.
struct SpotSighting {
    std::size_t index = 0;  ///< of the pointing in the order
    geometry::Pointing at;  ///< circle readings on arrival
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    double score = 0.0;
    double sigma_px = 0.0;
    camera::FramePtr frame;  ///< that showed it
    bool relayed = false;  ///< known again by its look at the nearest sighting, no longer by the clicked one
};

/// A pointing from which the spot was not found, and why.
struct MissedPointing {
    std::size_t index = 0;
    core::Error reason;
};

struct SweepOutcome {
    std::vector<SpotSighting> sightings;  ///< in the order they were taken
    std::vector<MissedPointing> missed;
};

struct SweepStep {
    std::size_t done = 0;
    std::size_t of = 0;
    std::optional<SpotSighting> sighting;  ///< of the pointing just done
    std::optional<MissedPointing> missed;
};

/// Turns the instrument through a list of pointings and finds one clicked spot in settled pictures at each: the
/// observations of the distortion table, the self-calibration and the check. Nothing is measured but circles
/// and pixels.
class SpotSweep {
public:
    SpotSweep(instrument::TotalStation& station, FrameAfter frame_after, FindPatch find, PixelToPointing model,
              core::Clock& clock, SweepSettings settings = {});

    /// The object outlives the task. A pointing that is barred, not reached or does not show the spot is
    /// missed and the sweep goes on; kCancelled, a lost instrument or camera, or most_misses in a row end it.
    [[nodiscard]] core::Task<core::Result<SweepOutcome>> run(Click click, std::vector<geometry::Pointing> pointings,
                                                             std::stop_token stop);

    std::function<void(const SweepStep&)> on_step;
    /// Asked before every move; its error makes the pointing missed.
    std::function<core::Result<void>(const geometry::Pointing& target)> may_turn;
    /// Of earlier sweeps of the same spot: it is looked for from the nearest of these too.
    std::vector<SpotSighting> seen_before;

private:
    struct Known;
    struct Course;

    [[nodiscard]] core::Task<core::Result<SpotSighting>> sight(std::shared_ptr<Course> course, std::size_t index,
                                                               std::stop_token stop);
    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> turn(geometry::Pointing target, std::stop_token stop) const;
    [[nodiscard]] core::Result<Known> nearest(const Course& course, const geometry::Pointing& at) const;
    [[nodiscard]] core::Result<void> keep(Course& course, std::size_t index,
                                          const core::Result<SpotSighting>& sighted) const;

    instrument::TotalStation& station_;
    FrameAfter frame_after_;
    FindPatch find_;
    PixelToPointing model_;
    core::Clock& clock_;
    SweepSettings settings_;
};

}  // namespace pmts::targeting
