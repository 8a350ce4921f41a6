#include "pmts/camera/scaled_picture.hpp"

#include "pmts/camera/scaled_rig.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace pmts::camera {
namespace {

/// Where a ray of a full HD camera's rig meets a picture of that camera, drawn as a disc, and found again.
struct Spot {
    double u, v;
};

Spot foundIn(const cv::Mat& picture) {
    cv::Mat grey;
    cv::extractChannel(picture - cv::Scalar::all(20), grey, 0);
    const cv::Moments moments = cv::moments(grey);
    return {moments.m10 / moments.m00, moments.m01 / moments.m00};
}

TEST(ScaledPictureTest, ShowsThingsWhereTheScaledRigExpectsThem) {
    Rig rig;
    rig.lens = Lens(BrownLens{.f_px = 2100.0, .cx_px = 950.0, .cy_px = 545.0});
    rig.width_px = 1920;
    rig.height_px = 1080;
    const Eigen::Vector3d ray(0.1, -0.05, 1.0);
    const Eigen::Vector2d px = *rig.lens.pixelFromCamera(ray);
    for (const cv::Size size : {cv::Size(1280, 720), cv::Size(640, 480), cv::Size(960, 480)}) {
        cv::Mat picture(1080, 1920, CV_8UC3, cv::Scalar::all(20));
        cv::circle(picture, {qRound(px.x()), qRound(px.y())}, 30, cv::Scalar::all(240), cv::FILLED, cv::LINE_AA);
        const Spot spot = foundIn(scaledPicture(picture, size.width, size.height));
        const Eigen::Vector2d expected = *scaledRig(rig, size.width, size.height).lens.pixelFromCamera(ray);
        EXPECT_NEAR(spot.u, expected.x(), 0.5) << size;  // the disc stands on whole pixels
        EXPECT_NEAR(spot.v, expected.y(), 0.7) << size;
    }
}

TEST(ScaledPictureTest, SameSizeIsTheSamePicture) {
    const cv::Mat picture(72, 128, CV_8UC3, cv::Scalar::all(20));
    EXPECT_EQ(scaledPicture(picture, 128, 72).data, picture.data);
}

}  // namespace
}  // namespace pmts::camera
