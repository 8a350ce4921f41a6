#pragma once

#include "pmts/calibration/rig_fit.hpp"

#include <array>
#include <optional>
#include <vector>

namespace pmts::calibration {

/// Which components of the offset are sought; the others are zero (thesis 5.4, its eight cases) or known: a
/// forward offset of 85 mm taken for zero makes the others 2 % of themselves wrong at 4 and 8 m.
struct OffsetCase {
    bool x = true;
    bool y = false;
    bool z = true;
    bool others_are_known = false;  ///< they keep the rig's values instead of zero

    [[nodiscard]] bool operator==(const OffsetCase&) const = default;
    [[nodiscard]] bool isNone() const { return !x && !y && !z; }
};

/// What two boards tell: the telescope was on a spot of the board at 2D, then on one of the board at D.
struct BoardGap {
    double near_m = 0.0;  ///< D, as measured
    double far_m = 0.0;   ///< about 2D, as measured
    /// On the near board: from where the camera's line through the far spot's pixel meets it to where the telescope does; to the right and up.
    Eigen::Vector2d gap_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d offset_m = Eigen::Vector2d::Zero();  ///< Xo, Zo: the gap times far / (far - near), twice the gap at D and 2D
};

/// The thesis's figure: both axes brought to meet at 2D, here by turning the lines instead of the camera, so
/// that its small rotations need not be known. `far` and `near` are sightings with the telescope on the
/// target itself (their `at` is the target's pointing). kBadInput unless far is at least 1.5 times near;
/// kUndefined where the lens has no ray.
[[nodiscard]] core::Result<BoardGap> gapAtNearBoard(const camera::Rig& rig, const Sighting& far, const Sighting& near);

/// Yaw, pitch and the offsets of the case from sightings at several ranges, everything else as in `initial`
/// (any lens, tables too).
struct MountFit {
    camera::Mount mount;
    double rms_px = 0.0;
    double largest_px = 0.0;
    /// One sigma of Xo, Yo, Zo for `pixel_sigma` px in each coordinate; absent for those not sought.
    std::array<std::optional<double>, 3> offset_sigma_m;
};

/// kBadInput with too few sightings for the case; kUndefined when they do not tell the offsets apart from
/// yaw and pitch: one range only, or Yo without a sighting away from the telescope's axis.
[[nodiscard]] core::Result<MountFit> fitMount(const std::vector<Sighting>& sightings, const camera::Rig& initial,
                                              const OffsetCase& sought, double pixel_sigma = 0.05);

/// Where the near board may hang.
struct BoardDistances {
    double telescope_close_m = 1.7;  ///< the telescope focuses no nearer
    double camera_close_m = 0.5;
    double offset_m = 0.05;          ///< about; the smallest that shall be found
};
struct NearBoardRange {
    double least_m = 0.0;  ///< both can focus
    double most_m = 0.0;   ///< farther, a pixel is wider than the offset

    [[nodiscard]] bool holds(double distance_m) const { return distance_m > least_m && distance_m < most_m; }
};
[[nodiscard]] NearBoardRange nearBoardRange(const BoardDistances& limits, double f_px);

}  // namespace pmts::calibration
