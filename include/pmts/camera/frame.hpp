#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/geometry/pointing.hpp"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <optional>

namespace pmts::camera {

/// One picture of the live view. Nobody writes to it after it left its source: share it freely between threads.
struct Frame {
    cv::Mat image;                  ///< 8-bit BGR, the pixel centre of the top-left pixel is (0, 0)
    core::Duration captured_at{0};  ///< exposure time on core::Clock's scale
    std::uint64_t sequence = 0;     ///< counts up by one for each frame of the device, dropped ones included
    std::optional<geometry::Pointing> pointing;  ///< circle readings at captured_at, when known
};

using FramePtr = std::shared_ptr<const Frame>;

}  // namespace pmts::camera
