#pragma once

#include "pmts/camera/rig.hpp"

namespace pmts::simulator {

/// The true rig of the simulated camera: strapped to the telescope 12 mm right of, 85 mm before and 52 mm
/// above the optical centre, a little turned against the line of sight, with a lens that bends like a
/// webcam's. Seeded data: a program may hand the same numbers to its user as the profile that a careful
/// calibration would have found.
[[nodiscard]] camera::Rig simulatedRig();

}  // namespace pmts::simulator
