#include "lens_figures.hpp"

#include "pmts/camera/lens.hpp"
#include "support/figure.hpp"

#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace pmts::bench {
namespace {

constexpr int kPoints = 20'000;
constexpr int kRuns = 9;
constexpr double kRayBudget_ns = 3000;  ///< all rays of a picture of 1280 x 720 within 3 s
const camera::RationalLens kRational{.f_px = 1000, .cx_px = 646, .cy_px = 355, .k1 = 0.3, .k2 = -0.08, .k3 = 0.01,
                                     .k4 = 0.65, .k5 = 0.05, .k6 = 0.002, .p1 = 6e-4, .p2 = -4e-4};
const camera::BrownLens kBrown{.f_px = 1400, .cx_px = 643, .cy_px = 357, .k1 = -0.12, .k2 = 0.02, .p1 = 6e-4, .p2 = -4e-4};
const camera::FisheyeLens kFisheye{.f_px = 700, .cx_px = 646, .cy_px = 355, .k1 = -0.03, .k2 = 0.004, .k3 = -0.001};

cv::Matx33d matrixOf(double f_px, double cx_px, double cy_px) { return {f_px, 0, cx_px, 0, f_px, cy_px, 0, 0, 1}; }

/// Points before the camera, as far off the axis as a picture of 1280 x 720 shows.
std::vector<cv::Point3d> pointsBefore(double widest) {
    cv::RNG random(11);
    std::vector<cv::Point3d> points(kPoints);
    for (cv::Point3d& point : points) {
        point = {random.uniform(-widest, widest), random.uniform(-0.56 * widest, 0.56 * widest), 1.0};
    }
    return points;
}

double farthest(const camera::Lens& lens, const std::vector<cv::Point3d>& points, const std::vector<cv::Point2d>& opencv) {
    double farthest_px = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto px = lens.pixelFromCamera({points[i].x, points[i].y, points[i].z});
        const double away_px = px ? std::hypot(px->x() - opencv[i].x, px->y() - opencv[i].y) : HUGE_VAL;
        farthest_px = std::max(farthest_px, away_px);
    }
    return farthest_px;
}

template <class Work>
double medianSeconds(Work work) {
    std::vector<double> seconds;
    for (int run = 0; run < kRuns; ++run) {
        const auto started = std::chrono::steady_clock::now();
        work();
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count());
    }
    return median(seconds);
}

/// Pixel to ray, where OpenCV iterates until it is as exact as ours: 1e-6 px.
void wayBack(const camera::Lens& lens, const cv::Matx33d& matrix, const std::vector<double>& distortion,
             const std::vector<cv::Point2d>& pixels) {
    std::vector<cv::Point2d> rays;
    const cv::TermCriteria exact(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-9);
    const double opencv_s = medianSeconds(
        [&] { cv::undistortPoints(pixels, rays, matrix, distortion, cv::noArray(), cv::noArray(), exact); });
    double sum = 0.0;
    const double ours_s = medianSeconds([&] {
        for (const cv::Point2d& px : pixels) {
            sum += lens.cameraFromPixel({px.x, px.y})->z();
        }
    });
    std::printf("# cv::undistortPoints in the same run: %.0f ns a pixel; it does not look for the fold (mean cosine %.3f)\n",
                1e9 * opencv_s / kPoints, sum / kPoints / kRuns);
    figure("camera.pixel_to_ray", 1e9 * ours_s / kPoints, "ns", Wanted::kAtMost, kRayBudget_ns);
}

}  // namespace

void lensFigures() {
    const cv::Vec3d none(0, 0, 0);
    std::vector<cv::Point2d> seen;

    const auto narrow = pointsBefore(0.45);
    const std::vector<double> brown{kBrown.k1, kBrown.k2, kBrown.p1, kBrown.p2, kBrown.k3};
    cv::projectPoints(narrow, none, none, matrixOf(kBrown.f_px, kBrown.cx_px, kBrown.cy_px), brown, seen);
    figure("camera.brown_against_opencv", farthest(camera::Lens(kBrown), narrow, seen), "px", Wanted::kAtMost, 1e-6);

    const auto wide = pointsBefore(0.65);
    const cv::Matx33d matrix = matrixOf(kRational.f_px, kRational.cx_px, kRational.cy_px);
    const std::vector<double> rational{kRational.k1, kRational.k2, kRational.p1, kRational.p2,
                                       kRational.k3, kRational.k4, kRational.k5, kRational.k6};
    cv::projectPoints(wide, none, none, matrix, rational, seen);
    const camera::Lens lens(kRational);
    figure("camera.rational_against_opencv", farthest(lens, wide, seen), "px", Wanted::kAtMost, 1e-6);
    wayBack(lens, matrix, rational, seen);

    const std::vector<double> fisheye{kFisheye.k1, kFisheye.k2, kFisheye.k3, kFisheye.k4};
    cv::fisheye::projectPoints(wide, seen, none, none, matrixOf(kFisheye.f_px, kFisheye.cx_px, kFisheye.cy_px), fisheye);
    figure("camera.fisheye_against_opencv", farthest(camera::Lens(kFisheye), wide, seen), "px", Wanted::kAtMost, 1e-6);
}

}  // namespace pmts::bench
