#include "pmts/camera/lens.hpp"
#include "support/matchers.hpp"

#include <opencv2/calib3d.hpp>

#include <numbers>
#include <random>

namespace pmts::camera {
namespace {

using test::FailedWith;

/// Eight numbers as OpenCV finds them for a wide action camera. The simulator's cameras are others on purpose: what
/// this room projects is held against OpenCV alone, whatever the simulator draws.
RationalLens actionCamera() {
    return {.f_px = 880,
            .cx_px = 644,
            .cy_px = 357,
            .k1 = 0.31,
            .k2 = 0.08,
            .k3 = 0.004,
            .k4 = 0.62,
            .k5 = 0.18,
            .k6 = 0.02,
            .p1 = 4e-4,
            .p2 = -3e-4};
}

FisheyeLens fisheye() {
    return {.f_px = 420, .cx_px = 640, .cy_px = 360, .k1 = -0.03, .k2 = 0.008, .k3 = -0.004, .k4 = 5e-4};
}

template <class Model>
void expectEveryPixelComesBack(const Model& model) {
    const Lens lens(model);
    for (double v = 0; v < 720; v += 24) {
        for (double u = 0; u < 1280; u += 32) {
            const auto ray = lens.cameraFromPixel({u, v});
            ASSERT_TRUE(ray.has_value()) << u << ' ' << v;
            EXPECT_NEAR(ray->norm(), 1.0, 1e-12);
            EXPECT_LT((*lens.pixelFromCamera(*ray) - Eigen::Vector2d(u, v)).norm(), 1e-6) << u << ' ' << v;
        }
    }
}

TEST(LensModelsTest, RationalLensProjectsAsOpenCvDoes) {
    const RationalLens lens = actionCamera();
    const cv::Matx33d camera(lens.f_px, 0, lens.cx_px, 0, lens.f_px, lens.cy_px, 0, 0, 1);
    const std::vector<double> distortion{lens.k1, lens.k2, lens.p1, lens.p2,
                                         lens.k3, lens.k4, lens.k5, lens.k6};
    std::mt19937 engine(21);
    std::uniform_real_distribution<double> across(-0.8, 0.8);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d p_camera = 3.0 * Eigen::Vector3d(across(engine), across(engine), 1.0);
        std::vector<cv::Point2d> opencv;
        cv::projectPoints(std::vector<cv::Point3d>{{p_camera.x(), p_camera.y(), p_camera.z()}}, cv::Vec3d(),
                          cv::Vec3d(), camera, distortion, opencv);
        const auto px = Lens(lens).pixelFromCamera(p_camera);
        ASSERT_TRUE(px.has_value());
        EXPECT_LT((*px - Eigen::Vector2d(opencv[0].x, opencv[0].y)).norm(), 1e-9);
    }
}

TEST(LensModelsTest, FisheyeProjectsAsOpenCvDoes) {
    const FisheyeLens lens = fisheye();
    const cv::Matx33d camera(lens.f_px, 0, lens.cx_px, 0, lens.f_px, lens.cy_px, 0, 0, 1);
    std::mt19937 engine(22);
    std::uniform_real_distribution<double> across(-4, 4);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d p_camera(across(engine), across(engine), 1.5);
        std::vector<cv::Point2d> opencv;
        cv::fisheye::projectPoints(std::vector<cv::Point3d>{{p_camera.x(), p_camera.y(), p_camera.z()}},
                                   opencv, cv::Vec3d(), cv::Vec3d(), camera,
                                   cv::Vec4d(lens.k1, lens.k2, lens.k3, lens.k4));
        const auto px = Lens(lens).pixelFromCamera(p_camera);
        ASSERT_TRUE(px.has_value());
        EXPECT_LT((*px - Eigen::Vector2d(opencv[0].x, opencv[0].y)).norm(), 1e-9);
    }
}

TEST(LensModelsTest, EveryPixelOfEitherLensGoesOutAndComesBack) {
    expectEveryPixelComesBack(actionCamera());
    expectEveryPixelComesBack(fisheye());
}

TEST(LensModelsTest, RationalLensEndsAtItsFoldAndAtTheZeroOfItsDenominator) {
    // Without a denominator it is Brown's: r (1 - r2 / 3) stops growing at r = 1.
    EXPECT_NEAR(Lens(RationalLens{.k1 = -1.0 / 3}).usableAngle_rad(), std::atan(1.0), 1e-9);
    // r / (1 + r2) grows up to r = 1 and falls from there.
    const Lens lens(RationalLens{.f_px = 300, .k4 = 1.0});
    EXPECT_NEAR(lens.usableAngle_rad(), std::atan(1.0), 1e-9);
    EXPECT_THAT(lens.pixelFromCamera({1.01, 0, 1}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(lens.cameraFromPixel({150.1, 0}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_NEAR(lens.cameraFromPixel({149.99999, 0})->x(), std::sqrt(0.5), 1e-3);
    // r / (1 - r2 / 4) reaches infinity at r = 2: past it the picture would start again from the other side.
    EXPECT_NEAR(Lens(RationalLens{.k4 = -0.25}).usableAngle_rad(), std::atan(2.0), 1e-9);
}

TEST(LensModelsTest, FisheyeEndsAtItsFoldAndSeesBesideItselfWithoutOne) {
    // t (1 - t2 / 3) stops growing at 1 rad, at a radius of 2/3.
    const Lens folded(FisheyeLens{.f_px = 300, .k1 = -1.0 / 3});
    EXPECT_NEAR(folded.usableAngle_rad(), 1.0, 1e-9);
    EXPECT_THAT(folded.pixelFromCamera({std::tan(1.001), 0, 1}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(folded.cameraFromPixel({200.01, 0}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_NEAR(folded.pixelFromCamera(*folded.cameraFromPixel({199.9999, 0}))->x(), 199.9999, 1e-6);

    const Lens wide(FisheyeLens{.f_px = 100});  // equidistant: 100 px for each rad, also past 100 gon
    EXPECT_NEAR(wide.pixelFromCamera({1, 0, 0})->x(), 50 * std::numbers::pi, 1e-9);
    EXPECT_NEAR(wide.cameraFromPixel({200, 0})->z(), std::cos(2.0), 1e-12);
    EXPECT_THAT(wide.cameraFromPixel({320, 0}), FailedWith(core::ErrorKind::kUndefined));
    EXPECT_THAT(wide.pixelFromCamera({0, 0, 0}), FailedWith(core::ErrorKind::kUndefined));
}

TEST(LensModelsTest, NumbersThatMakeNoLensAreRefused) {
    EXPECT_THROW(Lens(RationalLens{.f_px = -1}), std::logic_error);
    EXPECT_THROW(Lens(RationalLens{.k6 = std::nan("")}), std::logic_error);
    EXPECT_THROW(Lens(FisheyeLens{.f_px = 0}), std::logic_error);
    EXPECT_THROW(Lens(FisheyeLens{.k4 = std::nan("")}), std::logic_error);
}

}  // namespace
}  // namespace pmts::camera
