#pragma once

#include "pmts/video/camera_control.hpp"

#include <vector>

class QCamera;

namespace pmts::video {

/// What Qt's backend lets us set of this camera; most of its backends let little.
[[nodiscard]] std::vector<CameraControlState> qtControls(const QCamera& camera);
void setQtControl(QCamera& camera, const ControlValue& wish);

}  // namespace pmts::video
