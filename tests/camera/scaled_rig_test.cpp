#include "pmts/camera/scaled_rig.hpp"

#include "support/matchers.hpp"

#include <opencv2/imgproc.hpp>

namespace pmts::camera {
namespace {

Rig webcam() {
    return {.lens = Lens(BrownLens{.f_px = 1400, .cx_px = 643.5, .cy_px = 357.5, .k1 = -0.12, .k2 = 0.02}),
            .mount = {}, .width_px = 1280, .height_px = 720};
}

const Eigen::Vector3d kPlace(0.21, -0.13, 1.0);

TEST(ScaledRigTest, HalfThePictureShowsTheSamePlaceWhereAreaResamplingPutsIt) {
    // A square around the place, drawn large and halved by OpenCV: its centre of mass is where the halved rig sees it.
    const auto px = webcam().lens.pixelFromCamera(kPlace);
    cv::Mat large(720, 1280, CV_32F, cv::Scalar(0));
    const cv::Point corner(static_cast<int>(px->x()) / 2 * 2, static_cast<int>(px->y()) / 2 * 2);
    large(cv::Rect(corner, cv::Size(8, 8))) = 1.0F;
    cv::Mat half;
    cv::resize(large, half, cv::Size(640, 360), 0, 0, cv::INTER_AREA);
    const cv::Moments in_large = cv::moments(large);
    const cv::Moments in_half = cv::moments(half);
    const Eigen::Vector2d beside = *px - Eigen::Vector2d(in_large.m10 / in_large.m00, in_large.m01 / in_large.m00);
    const Eigen::Vector2d expected = Eigen::Vector2d(in_half.m10 / in_half.m00, in_half.m01 / in_half.m00) + beside / 2;

    const auto seen = scaledRig(webcam(), 640, 360).lens.pixelFromCamera(kPlace);
    EXPECT_LT((*seen - expected).norm(), 1e-5);
}

TEST(ScaledRigTest, TableScalesLikeTheLens) {
    Rig rig = webcam();
    rig.lens = Lens(RadialTableLens{.cx_px = 640, .cy_px = 360, .rows = {{0, 0}, {300, 0.21}, {800, 0.5}}});
    const Rig large = scaledRig(rig, 1920, 1080);
    const auto px = rig.lens.pixelFromCamera(kPlace);
    const auto large_px = large.lens.pixelFromCamera(kPlace);
    EXPECT_LT((*large_px - ((*px + Eigen::Vector2d(0.5, 0.5)) * 1.5 - Eigen::Vector2d(0.5, 0.5))).norm(), 1e-6);
    EXPECT_EQ(large.height_px, 1080);
}

TEST(ScaledRigTest, AnotherShapeKeepsTheMiddleInTheMiddle) {
    Rig rig = webcam();
    rig.lens = Lens(BrownLens{.f_px = 1400, .cx_px = 639.5, .cy_px = 359.5});
    const Eigen::Vector2d centre = scaledRig(rig, 640, 480).lens.principalPoint();
    EXPECT_LT((centre - Eigen::Vector2d(319.5, 239.5)).norm(), 1e-9);
}

TEST(ScaledRigTest, SameSizeChangesNothing) {
    EXPECT_EQ(scaledRig(webcam(), 1280, 720).lens.model(), webcam().lens.model());
}

}  // namespace
}  // namespace pmts::camera
