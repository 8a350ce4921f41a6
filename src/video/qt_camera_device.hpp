#pragma once

#include "capture_device.hpp"
#include "qt_camera_backend.hpp"

namespace pmts::video {

/// The camera of this description behind the given backend.
[[nodiscard]] std::unique_ptr<CaptureDevice> makeQtCameraDevice(const QString& description,
                                                                std::unique_ptr<QtCameraBackend> backend);

}  // namespace pmts::video
