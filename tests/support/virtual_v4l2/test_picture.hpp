#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pmts::virtual_v4l2 {

/// A camera's picture format.
struct PictureShape {
    std::uint32_t fourcc = 0;
    std::uint32_t width = 640;
    std::uint32_t height = 480;

    [[nodiscard]] std::uint32_t rowBytes() const;
    [[nodiscard]] std::uint32_t sizeBytes() const;
};

/// Grey with a bright 40 px square that starts at the left in the middle row and moves 8 px to the right each
/// frame.
void drawTestPicture(const PictureShape& shape, std::uint32_t sequence, std::uint8_t* pixels);

/// `0.jpg`, `1.jpg` and so on of a folder, until one is missing.
[[nodiscard]] std::vector<std::string> jpegPictures(const std::string& folder);

}  // namespace pmts::virtual_v4l2
