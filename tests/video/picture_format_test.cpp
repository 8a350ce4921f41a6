#include "picture_format.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace pmts::video {
namespace {

RawPicture raw(PixelLayout layout, int width, int height, std::size_t row_bytes,
               const std::vector<std::uint8_t>& bytes) {
    return {layout, width, height, row_bytes, bytes.data(), bytes.size()};
}

/// BT.601 with 16..235 luma, as webcams send it: Y 81, U 90, V 240 is pure red.
constexpr std::uint8_t kRedY = 81, kRedU = 90, kRedV = 240;

void expectRed(const cv::Vec3b& pixel) {
    EXPECT_LE(pixel[0], 3);
    EXPECT_LE(pixel[1], 3);
    EXPECT_GE(pixel[2], 252);
}

TEST(PictureFormatTest, YuyvRedIsRed) {
    std::vector<std::uint8_t> bytes;
    for (int pair = 0; pair < 4; ++pair) {
        bytes.insert(bytes.end(), {kRedY, kRedU, kRedY, kRedV});
    }
    const cv::Mat bgr = bgrFrom(raw(PixelLayout::kYuyv, 4, 2, 8, bytes));
    ASSERT_EQ(bgr.size(), cv::Size(4, 2));
    expectRed(bgr.at<cv::Vec3b>(1, 3));
}

TEST(PictureFormatTest, Nv12RedIsRed) {
    std::vector<std::uint8_t> bytes(4 * 2, kRedY);
    bytes.insert(bytes.end(), {kRedU, kRedV, kRedU, kRedV});
    const cv::Mat bgr = bgrFrom(raw(PixelLayout::kNv12, 4, 2, 4, bytes));
    ASSERT_EQ(bgr.size(), cv::Size(4, 2));
    expectRed(bgr.at<cv::Vec3b>(0, 0));
}

TEST(PictureFormatTest, MotionJpegIsDecoded) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", cv::Mat(16, 24, CV_8UC3, cv::Scalar(20, 120, 220)), bytes);
    const cv::Mat bgr = bgrFrom(raw(PixelLayout::kMjpg, 24, 16, 0, bytes));
    ASSERT_EQ(bgr.size(), cv::Size(24, 16));
    EXPECT_NEAR(bgr.at<cv::Vec3b>(8, 8)[2], 220, 3);
}

TEST(PictureFormatTest, RowsMayBeLongerThanThePicture) {
    const std::vector<std::uint8_t> bytes(2 * 16, 7);
    EXPECT_EQ(bgrFrom(raw(PixelLayout::kBgr, 4, 2, 16, bytes)).size(), cv::Size(4, 2));
}

TEST(PictureFormatTest, ShortBuffersAndDamagedJpegsGiveNoPicture) {
    const std::vector<std::uint8_t> bytes(10, 0x5a);
    EXPECT_TRUE(bgrFrom(raw(PixelLayout::kYuyv, 4, 2, 8, bytes)).empty());
    EXPECT_TRUE(bgrFrom(raw(PixelLayout::kNv12, 4, 2, 4, bytes)).empty());
    EXPECT_TRUE(bgrFrom(raw(PixelLayout::kMjpg, 4, 2, 0, bytes)).empty());
}

}  // namespace
}  // namespace pmts::video
