#pragma once

#include "pmts/camera/rig.hpp"

namespace pmts::camera {

/// The same camera in another mode: its picture scaled until it fills the new size, and cut evenly about its middle
/// where the sides' ratio differs. True for modes that use the whole sensor; a calibration in the mode itself is better.
///     u' + 0.5 = s (u + 0.5) - cut
[[nodiscard]] Rig scaledRig(const Rig& rig, int width_px, int height_px);

}  // namespace pmts::camera
