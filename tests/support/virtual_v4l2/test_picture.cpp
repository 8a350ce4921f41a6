#include "test_picture.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <linux/videodev2.h>

namespace pmts::virtual_v4l2 {
namespace {

constexpr std::uint8_t kGrey = 100, kBright = 235, kNoColour = 128;
constexpr std::uint32_t kSquare = 40, kStep = 8;

}  // namespace

std::uint32_t PictureShape::rowBytes() const { return fourcc == V4L2_PIX_FMT_YUYV ? width * 2 : width; }

std::uint32_t PictureShape::sizeBytes() const {
    return fourcc == V4L2_PIX_FMT_YUYV ? width * height * 2 : width * height * 3 / 2;
}

void drawTestPicture(const PictureShape& shape, std::uint32_t sequence, std::uint8_t* pixels) {
    const bool yuyv = shape.fourcc == V4L2_PIX_FMT_YUYV;
    const std::uint32_t step = yuyv ? 2 : 1;  // bytes from one luma value to the next
    const std::uint32_t left = sequence * kStep % (shape.width - kSquare);
    const std::uint32_t top = (shape.height - kSquare) / 2;
    std::memset(pixels, kNoColour, shape.sizeBytes());
    for (std::uint32_t row = 0; row < shape.height; ++row) {
        for (std::uint32_t col = 0; col < shape.width; ++col) {
            const bool inside =
                col - left < kSquare && row - top < kSquare;  // unsigned: below the edge wraps to huge
            pixels[static_cast<std::size_t>(row) * shape.rowBytes() + col * step] = inside ? kBright : kGrey;
        }
    }
}

std::vector<std::string> jpegPictures(const std::string& folder) {
    std::vector<std::string> pictures;
    while (true) {
        std::ifstream file(folder + "/" + std::to_string(pictures.size()) + ".jpg", std::ios::binary);
        if (!file) {
            return pictures;
        }
        pictures.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
}

}  // namespace pmts::virtual_v4l2
