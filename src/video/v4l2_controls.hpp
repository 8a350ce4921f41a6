#pragma once

#include "pmts/video/camera_control.hpp"

#include <vector>

namespace pmts::video {

/// Exposure, gain, white balance, focus and zoom of an opened V4L2 device, as far as it has them.
/// The driver counts exposure in 0.1 ms (V4L2_CID_EXPOSURE_ABSOLUTE); here it is ms.
[[nodiscard]] std::vector<CameraControlState> v4l2Controls(int fd);
/// A control the device does not have, or refuses, is left alone.
void setV4l2Control(int fd, const ControlValue& wish);

}  // namespace pmts::video
