#include "present_cameras.hpp"

#include "support.hpp"
#include "v4l2_capture.hpp"
#include "v4l2_device.hpp"

#include <gmock/gmock.h>

namespace pmts::video {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

QStringList names(const std::vector<SourceAddress>& cameras) {
    QStringList all;
    for (const SourceAddress& camera : cameras) {
        all.append(camera.name);
    }
    return all;
}

TEST(PresentCamerasTest, ListsEachCaptureNodeInNumericOrderAndNoMetadataNode) {
    const CameraFolder folder;
    folder.plug("video10", "card=Tail camera");
    folder.plug("video2", "card=Front camera");
    folder.plug("video3", "card=Front camera\nmetadata=1");

    const auto cameras = v4l2Cameras(folder.path());

    EXPECT_EQ(names(cameras), QStringList({QStringLiteral("Front camera"), QStringLiteral("Tail camera")}));
    EXPECT_EQ(cameras.at(0).location, folder.node("video2"));
    EXPECT_EQ(cameras.at(0).kind, SourceKind::kV4l2);
}

TEST(PresentCamerasTest, QtCamerasAreAddedOnceAndOnlyWhenV4l2HasThemNot) {
    const SourceAddress webcam{SourceKind::kV4l2, QStringLiteral("/dev/video0"), QStringLiteral("Webcam")};
    const auto cameras =
        mergedCameras({webcam}, {QStringLiteral("Webcam"), QStringLiteral("Phone"), QStringLiteral("Phone")});
    EXPECT_EQ(names(cameras), QStringList({QStringLiteral("Webcam"), QStringLiteral("Phone")}));
}

TEST(V4l2DeviceTest, EnumeratesSizesAndRatesOfTheLayoutsItCanRead) {
    const CameraFolder folder;
    folder.plug("video0", "card=Webcam");
    const auto device = V4l2Device::open(folder.node("video0"));
    ASSERT_TRUE(device.has_value());
    EXPECT_EQ(device->cardName(), QStringLiteral("Webcam"));
    const std::vector<VideoFormat> formats = device->formats();
    ASSERT_THAT(formats, SizeIs(12));  // three sizes, two rates, two layouts
    EXPECT_EQ(formats[2], (VideoFormat{QSize(1280, 720), 30.0, QStringLiteral("YUYV")}));
    EXPECT_EQ(formats[3].rate_hz, 15.0);
    EXPECT_EQ(formats[6].pixel_format, QStringLiteral("NV12"));
}

TEST(V4l2DeviceTest, TakesTheNearestSizeToTheWish) {
    const CameraFolder folder;
    folder.plug("video0", "");
    auto device = V4l2Device::open(folder.node("video0"));
    ASSERT_TRUE(device.has_value());
    const auto got = device->configure({QSize(2048, 1152), 30.0, QStringLiteral("NV12")});
    ASSERT_TRUE(got.has_value());
    EXPECT_EQ(got->size, QSize(1920, 1080));
    EXPECT_EQ(got->pixel_format, QStringLiteral("NV12"));
}

}  // namespace
}  // namespace pmts::video
