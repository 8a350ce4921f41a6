#pragma once

#include "pmts/camera/frame.hpp"
#include "pmts/core/task.hpp"
#include "pmts/instrument/total_station.hpp"
#include "pmts/targeting/find_patch.hpp"
#include "pmts/targeting/pixel_to_pointing.hpp"

#include <functional>
#include <optional>
#include <stop_token>

namespace pmts::targeting {

/// The next frame exposed after `since` (core::Clock's scale), or kCamera when none comes.
using FrameAfter =
    std::function<core::Task<core::Result<camera::FramePtr>>(core::Duration since, std::stop_token stop)>;

struct RecentringSettings {
    core::Angle turn_tolerance = core::Angle::fromCc(5);
    double tolerance_px = 0.1;
    core::Angle tolerance = core::Angle::fromArcsec(20);  ///< settled when either of the two holds
    int most_moves = 4;
    double search_radius_px = 60.0;  ///< of the first look; later ones know more
    double still_px = 0.25;          ///< two frames in a row agree: nothing swings any more
    int most_frames = 12;            ///< awaited after each move for that
};

/// What was clicked, and when.
struct Click {
    camera::FramePtr frame;
    geometry::Pointing at;  ///< circle readings of the frame
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    double slope_distance_m = 0.0;  ///< measured, predicted or assumed: the reticle is drawn for it
    /// Where the first move goes when another method than the rig model chose it; absent: the rig model's.
    std::optional<geometry::Pointing> first_target = std::nullopt;
    std::optional<Patch> patch = std::nullopt;  ///< taken ahead; absent: the routine takes it before it moves
};

/// How well the telescope was put on the clicked spot: the evidence of a point.
struct Recentred {
    geometry::Pointing pointing;
    Eigen::Vector2d residual_px = Eigen::Vector2d::Zero();  ///< the spot against the reticle
    core::Angle residual;
    double score = 0.0;
    double runner_up = 0.0;
    double sigma_px = 0.0;
    int moves = 0;
    camera::FramePtr before, after;
    Eigen::Vector2d spot_px = Eigen::Vector2d::Zero();  ///< in `after`
};

enum class RecentringStage { kTurning, kLooking, kMatched };

struct RecentringStep {
    RecentringStage stage = RecentringStage::kTurning;
    int move = 1;
    geometry::Pointing target;         ///< where this move goes
    std::optional<Recentred> matched;  ///< with kMatched
};

/// Turns to a clicked spot and proves it: turn, find the patch in settled frames, turn again until the
/// residual is below the tolerance (features K9). Coordinates still come from the circles; the picture only
/// aims. What the picture did during a move corrects the rig model's scale and twist for the next one, so
/// that a rig a few per cent wrong still needs no more than three.
class Recentring {
public:
    Recentring(instrument::TotalStation& station, FrameAfter frame_after, FindPatch find,
               PixelToPointing model, core::Clock& clock, RecentringSettings settings = {});

    /// The object outlives the task. Fails with the matcher's errors, the station's, kCancelled, kCamera, or
    /// kNotReached when the moves are used up; the instrument then stays where it is.
    [[nodiscard]] core::Task<core::Result<Recentred>> turnTo(Click click, std::stop_token stop);

    std::function<void(const RecentringStep&)> on_step;
    /// Asked before every move; its error ends the routine.
    std::function<core::Result<void>(const geometry::Pointing& target)> may_turn;

private:
    struct Search;

    [[nodiscard]] core::Task<core::Result<geometry::Pointing>> move(geometry::Pointing target, std::stop_token stop) const;
    [[nodiscard]] core::Task<core::Result<void>> look(std::shared_ptr<Search> search, std::stop_token stop);
    [[nodiscard]] core::Result<Recentred> judged(const Search& search) const;
    [[nodiscard]] core::Result<geometry::Pointing> nextTarget(const Search& search) const;
    [[nodiscard]] core::Result<geometry::Pointing> pointingOf(const Eigen::Vector2d& px,
                                                              const geometry::Pointing& at,
                                                              double range_m) const;
    [[nodiscard]] bool isSettled(const Recentred& step) const;
    void report(RecentringStep step) const;

    instrument::TotalStation& station_;
    FrameAfter frame_after_;
    FindPatch find_;
    PixelToPointing model_;
    core::Clock& clock_;
    RecentringSettings settings_;
};

}  // namespace pmts::targeting
