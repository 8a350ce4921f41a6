#pragma once

#include "pmts/camera/rig.hpp"

namespace pmts::camera {

/// The same camera read out at another size: the picture is resampled by width_px / rig.width_px about its upper left
/// corner, pixel centres kept (the first pixel's centre is (0, 0), its corner (-0.5, -0.5)). The mount stays.
/// A size of another shape is taken as the same picture cropped or widened evenly above and below.
[[nodiscard]] Rig scaledRig(const Rig& rig, int width_px, int height_px);

}  // namespace pmts::camera
