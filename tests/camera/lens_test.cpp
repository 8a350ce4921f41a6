#include "pmts/camera/lens.hpp"

#include "support/matchers.hpp"

#include <opencv2/calib3d.hpp>

#include <random>

namespace pmts::camera {
namespace {

using test::FailedWith;

BrownLens webcam() {
    return {.f_px = 762,
            .cx_px = 318,
            .cy_px = 236,
            .k1 = -0.31,
            .k2 = 0.12,
            .k3 = -0.01,
            .p1 = 8e-4,
            .p2 = -5e-4};
}

/// OpenCV's own projection of a point in the camera frame.
Eigen::Vector2d projectedByOpenCv(const BrownLens& lens, const Eigen::Vector3d& p) {
    const cv::Matx33d camera(lens.f_px, 0, lens.cx_px, 0, lens.f_px, lens.cy_px, 0, 0, 1);
    const std::vector<double> distortion{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3};
    std::vector<cv::Point2d> pixels;
    cv::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, cv::Vec3d(), cv::Vec3d(), camera,
                      distortion, pixels);
    return {pixels[0].x, pixels[0].y};
}

TEST(LensTest, BrownModelProjectsAsOpenCvDoes) {
    const Lens lens(webcam());
    std::mt19937 engine(11);
    std::uniform_real_distribution<double> across(-0.6, 0.6);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d p_camera = 7.5 * Eigen::Vector3d(across(engine), across(engine), 1.0);
        const auto px = lens.pixelFromCamera(p_camera);
        ASSERT_TRUE(px.has_value());
        EXPECT_LT((*px - projectedByOpenCv(webcam(), p_camera)).norm(), 1e-9);
    }
}

TEST(LensTest, EveryPixelOfTheWebcamGoesOutAndComesBack) {
    const Lens lens(webcam());
    for (double v = 0; v < 480; v += 12) {
        for (double u = 0; u < 640; u += 16) {
            const auto ray = lens.cameraFromPixel({u, v});
            ASSERT_TRUE(ray.has_value()) << u << ' ' << v;
            EXPECT_NEAR(ray->norm(), 1.0, 1e-12);
            EXPECT_LT((*lens.pixelFromCamera(*ray) - Eigen::Vector2d(u, v)).norm(), 1e-6);
        }
    }
}

TEST(LensTest, RaysComeBackToTheirDirectionForRandomLenses) {
    std::mt19937 engine(12);
    std::uniform_real_distribution<double> k(-0.15, 0.15), p(-1e-3, 1e-3), across(-0.5, 0.5);
    for (int i = 0; i < 300; ++i) {
        const Lens lens(BrownLens{.f_px = 1000,
                                  .cx_px = 640,
                                  .cy_px = 360,
                                  .k1 = k(engine),
                                  .k2 = k(engine) / 2,
                                  .k3 = k(engine) / 4,
                                  .p1 = p(engine),
                                  .p2 = p(engine)});
        const Eigen::Vector3d direction = Eigen::Vector3d(across(engine), across(engine), 1).normalized();
        const auto px = lens.pixelFromCamera(direction);
        ASSERT_TRUE(px.has_value());
        const auto again = lens.cameraFromPixel(*px);
        ASSERT_TRUE(again.has_value());
        EXPECT_LT((*again - direction).norm(), 1e-9);
    }
}

TEST(LensTest, PinholeFollowsTheRuleOfThree) {
    const Lens lens(BrownLens{.f_px = 784, .cx_px = 315, .cy_px = 240});
    // 1 m to the right and 0.5 m below the axis at 8 m: an eighth and a sixteenth of 784 px; v grows
    // downwards.
    EXPECT_TRUE(lens.pixelFromCamera({1, 0.5, 8})->isApprox(Eigen::Vector2d(413, 289), 1e-12));
    EXPECT_TRUE(lens.cameraFromPixel({315, 240})->isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
    EXPECT_DOUBLE_EQ(lens.focalLengthPx(), 784);
}

TEST(LensTest, PointBehindTheCameraHasNoPixel) {
    const Lens lens(webcam());
    EXPECT_THAT(lens.pixelFromCamera({0, 0, -1}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(lens.pixelFromCamera({0.1, 0, 0}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(lens.pixelFromCamera({std::nan(""), 0, 1}), FailedWith(core::ErrorKind::kUndefined));
}

TEST(LensTest, BarrelModelEndsAtItsFold) {
    // k1 = -1/3: r (1 - r2 / 3) stops growing at r = 1, where it is 2/3; past it the model folds back into
    // the picture.
    const Lens lens(BrownLens{.f_px = 300, .k1 = -1.0 / 3});
    EXPECT_NEAR(lens.pixelFromCamera({0.999999, 0, 1})->x(), 200.0, 1e-6);
    EXPECT_THAT(lens.pixelFromCamera({1.001, 0, 1}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_TRUE(lens.cameraFromPixel({199.99, 0}).has_value());
    EXPECT_THAT(lens.cameraFromPixel({200.01, 0}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_NEAR(lens.usableAngle_rad(), std::atan(1.0), 1e-9);
}

TEST(LensTest, RayNextToTheFoldStillComesBackToItsPixel) {
    const Lens lens(BrownLens{.f_px = 300, .k1 = -1.0 / 3});
    for (const double u : {199.0, 199.9, 199.99, 199.9999}) {
        const auto ray = lens.cameraFromPixel({u, 0});
        ASSERT_TRUE(ray.has_value()) << u;
        EXPECT_NEAR(lens.pixelFromCamera(*ray)->x(), u, 1e-6);
        EXPECT_LT(ray->x() / ray->z(), 1.0);
    }
}

TEST(LensTest, FoldIsFoundWhereHigherTermsMakeOrUndoIt) {
    // 1 - 3 s + 2 s2 = 0 first at s = 1/2: k1 = -1, k2 = 0.4, although the outermost part grows again.
    EXPECT_NEAR(Lens(BrownLens{.k1 = -1, .k2 = 0.4}).usableAngle_rad(), std::atan(std::sqrt(0.5)), 1e-9);
    // 1 - 3 s + 2.25 s2 + 7 s3 stays positive.
    EXPECT_NEAR(Lens(BrownLens{.k1 = -1, .k2 = 0.45, .k3 = 1}).usableAngle_rad(), std::numbers::pi / 2,
                1e-12);
    EXPECT_NEAR(Lens(BrownLens{.k3 = -1.0 / 7}).usableAngle_rad(), std::atan(1.0), 1e-9);
}

TEST(LensTest, PixelFarOutsideAnyPictureHasNoRayOrALevelOneButAlwaysAnAnswer) {
    // A fold so far out that it counts as none: the search for the radius must end all the same.
    EXPECT_FALSE(Lens(BrownLens{.k1 = -1e-12}).cameraFromPixel({1e9, 0}).has_value());
    EXPECT_TRUE(Lens(BrownLens{}).cameraFromPixel({1e9, 0}).has_value());
    EXPECT_FALSE(Lens(BrownLens{}).cameraFromPixel({std::nan(""), 0}).has_value());
}

TEST(LensTest, ParametersThatMakeNoLensAreRefused) {
    EXPECT_THROW(Lens(BrownLens{.f_px = 0}), std::logic_error);
    EXPECT_THROW(Lens(BrownLens{.f_px = std::nan("")}), std::logic_error);
    EXPECT_THROW(Lens(BrownLens{.k2 = std::nan("")}), std::logic_error);
}

}  // namespace
}  // namespace pmts::camera
