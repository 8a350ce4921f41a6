#include "qt_frame.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <array>

namespace pmts::video {
namespace {

using Format = QVideoFrameFormat::PixelFormat;
using Bytes = std::vector<std::uint8_t>;

/// Every row of every plane filled with the bytes of that plane, over and over.
QVideoFrame frameOf(Format format, const QSize& size, const std::vector<Bytes>& planes) {
    QVideoFrame frame(QVideoFrameFormat(size, format));
    if (!frame.map(QVideoFrame::WriteOnly)) {
        return {};
    }
    for (int plane = 0; plane < frame.planeCount(); ++plane) {
        const Bytes& pattern = planes.at(static_cast<std::size_t>(plane));
        const auto row_bytes = static_cast<std::size_t>(frame.bytesPerLine(plane));
        for (int i = 0; i < frame.mappedBytes(plane); ++i) {
            frame.bits(plane)[i] = pattern[static_cast<std::size_t>(i) % row_bytes % pattern.size()];
        }
    }
    frame.unmap();
    return frame;
}

struct Pixels {
    const char* name;
    Format format;
    std::vector<Bytes> planes;
    cv::Vec3b bgr;
    int tolerance;  ///< of a channel; conversions of YUV round
};

class QtFrameTest : public testing::TestWithParam<Pixels> {};

TEST_P(QtFrameTest, KnownBytesBecomeTheirColour) {
    const cv::Mat bgr = bgrFromQt(frameOf(GetParam().format, {8, 4}, GetParam().planes));
    ASSERT_EQ(bgr.size(), cv::Size(8, 4));
    ASSERT_EQ(bgr.type(), CV_8UC3);
    for (const cv::Vec3b& pixel : {bgr.at<cv::Vec3b>(0, 0), bgr.at<cv::Vec3b>(3, 7)}) {
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(pixel[channel], GetParam().bgr[channel], GetParam().tolerance) << channel;
        }
    }
}

/// BT.601 with 16..235 luma: Y 81, U 90, V 240 is pure red, Y 41, U 240, V 110 pure blue.
INSTANTIATE_TEST_SUITE_P(
    EveryLayout, QtFrameTest,
    testing::Values(Pixels{"yuyv", Format::Format_YUYV, {{81, 90, 81, 240}}, {0, 0, 255}, 3},
                    Pixels{"nv12", Format::Format_NV12, {{41}, {240, 110}}, {255, 0, 0}, 3},
                    Pixels{"bgra", Format::Format_BGRA8888, {{10, 120, 230, 255}}, {10, 120, 230}, 0},
                    Pixels{"bgrx", Format::Format_BGRX8888, {{10, 120, 230, 0}}, {10, 120, 230}, 0},
                    Pixels{"rgba", Format::Format_RGBA8888, {{230, 120, 10, 255}}, {10, 120, 230}, 0},
                    Pixels{"rgbx", Format::Format_RGBX8888, {{230, 120, 10, 0}}, {10, 120, 230}, 0},
                    Pixels{"grey", Format::Format_Y8, {{77}}, {77, 77, 77}, 0}),
    [](const auto& pixels) { return std::string(pixels.param.name); });

TEST(QtFrameTest, JpegIsDecoded) {
    Bytes jpeg;
    cv::imencode(".jpg", cv::Mat(16, 24, CV_8UC3, cv::Scalar(20, 120, 220)), jpeg);
    QVideoFrame frame(QVideoFrameFormat({64, 64}, Format::Format_Jpeg));
    ASSERT_TRUE(frame.map(QVideoFrame::WriteOnly));
    ASSERT_LE(jpeg.size(), static_cast<std::size_t>(frame.mappedBytes(0)));
    std::ranges::copy(jpeg, frame.bits(0));
    frame.unmap();
    const cv::Mat bgr = bgrFromQt(frame);
    ASSERT_EQ(bgr.size(), cv::Size(24, 16));
    EXPECT_NEAR(bgr.at<cv::Vec3b>(8, 12)[2], 220, 3);
}

TEST(QtFrameTest, UnreadableLayoutGivesNoPicture) {
    EXPECT_FALSE(isReadable(Format::Format_YUV420P));
    EXPECT_TRUE(bgrFromQt(frameOf(Format::Format_YUV420P, {8, 4}, {{81}, {90}, {240}})).empty());
    EXPECT_TRUE(bgrFromQt({}).empty());
}

TEST(QtFrameTest, PictureOutlivesItsFrame) {
    QVideoFrame frame = frameOf(Format::Format_BGRA8888, {8, 4}, {{10, 120, 230, 255}});
    const cv::Mat bgr = bgrFromQt(frame);
    ASSERT_TRUE(frame.map(QVideoFrame::WriteOnly));
    std::fill_n(frame.bits(0), frame.mappedBytes(0), std::uint8_t{0});
    frame.unmap();
    EXPECT_EQ(bgr.at<cv::Vec3b>(2, 2), cv::Vec3b(10, 120, 230));
}

}  // namespace
}  // namespace pmts::video
