#pragma once

#include "pmts/camera/rig.hpp"
#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"

#include <Eigen/Core>

#include <vector>

namespace pmts::calibration {

struct SweepPlanOptions {
    int most_pointings = 60;  ///< both faces together
    double margin_px = 24.0;  ///< nearer to the edge a patch cannot be found
    /// 0: an even grid. 1: closer towards the edges, where the lens bends most and the centre shows best.
    double towards_edges = 0.85;
    double reach = 1.0;         ///< share of the picture's width and height that is swept
    bool centre_out = false;    ///< begins in the middle: what is seen there helps to find it further out
    bool both_faces = true;     ///< ignored for a camera on the handle: in face II it looks to the back
    double speed_gon_s = 50.0;  ///< of either motor
    double acceleration_gon_s2 = 100.0;
    core::Duration settle = std::chrono::milliseconds(1000);
    core::Duration look = std::chrono::milliseconds(250);  ///< readings, and two frames that agree
};

/// Pointings that carry one spot over the whole picture, in the order of the shortest way.
struct SweepPlan {
    std::vector<geometry::Pointing> pointings;
    std::vector<Eigen::Vector2d> wanted_px;  ///< where each of them should show the spot
    core::Duration instrument_time{0};       ///< moves, settling and looking, from the first to the last
};

/// Plans the sweep of a spot at `p_station` with what is known of the camera. A camera on the telescope is
/// swept over a grid in face I and over the same grid half a step on in face II, where it stands on its head:
/// that tells its yaw and pitch from the direction of the spot. A camera on the handle can be swept along a
/// row only. kUndefined when the spot cannot be brought into the picture.
[[nodiscard]] core::Result<SweepPlan> planSweep(const camera::Rig& about, const Eigen::Vector3d& p_station,
                                                const SweepPlanOptions& options = {});

/// Small sweeps before the large one, each further out, from which roughRig() learns what the next one needs:
/// a spot looks the same for 150 px round about under any lens, further out only when the lens is known
/// roughly, and at the edge of a strongly bent one only when it is known nearly as far out.
inline constexpr int kScoutingStages = 3;
[[nodiscard]] SweepPlanOptions scouting(int stage);

/// Time a motor needs for this way: accelerates, cruises, brakes.
[[nodiscard]] core::Duration turningTime(double way_gon, double speed_gon_s, double acceleration_gon_s2);

}  // namespace pmts::calibration
