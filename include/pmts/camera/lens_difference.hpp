#pragma once

#include "pmts/camera/rig.hpp"

namespace pmts::camera {

/// How differently two lenses see, after the turn that brings their rays together best is taken out: a shifted
/// principal point with a turned mount is nearly the same camera.
struct LensDifference {
    double rms_px = 0.0;      ///< over a grid of the picture, lengths, in pixels of the first lens at the axis
    double largest_px = 0.0;
    Eigen::Vector2d largest_at_px = Eigen::Vector2d::Zero();
    Eigen::Matrix3d first_from_second = Eigen::Matrix3d::Identity();  ///< that turn, camera frames
    double compared = 0.0;    ///< share of the grid that both lenses have rays for
};

/// kUndefined when the lenses share less than a quarter of the picture.
[[nodiscard]] core::Result<LensDifference> lensDifference(const Lens& first, const Lens& second, int width_px, int height_px);

/// The rig with another lens: offsets and mount kind stay, and the camera's small rotation follows, so that over the picture pixels
/// keep looking where they looked. Fails like lensDifference().
[[nodiscard]] core::Result<Rig> withLens(const Rig& rig, const Lens& lens);

}  // namespace pmts::camera
