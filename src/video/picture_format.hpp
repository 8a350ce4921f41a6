#pragma once

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>

namespace pmts::video {

/// Pixel layouts cameras send, by their V4L2 name.
enum class PixelLayout { kYuyv, kMjpg, kNv12, kBgr };

/// A picture as it lies in a driver's buffer.
struct RawPicture {
    PixelLayout layout = PixelLayout::kYuyv;
    int width_px = 0;
    int height_px = 0;
    std::size_t row_bytes = 0;
    const std::uint8_t* data = nullptr;
    std::size_t size_bytes = 0;
};

/// An own BGR copy; empty when the buffer is too short or the JPEG is damaged.
[[nodiscard]] cv::Mat bgrFrom(const RawPicture& raw);

}  // namespace pmts::video
