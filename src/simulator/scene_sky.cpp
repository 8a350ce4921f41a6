#include "scene_sky.hpp"

#include "scene_noise.hpp"

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace pmts::simulator {
namespace {

constexpr int kFacePx = 448;
constexpr int kCloudPx = 1024;
const cv::Scalar kHaze(226, 216, 205);

/// Clouds as a plane overhead: what a direction meets 1 unit above the camera.
struct Clouds {
    cv::Mat cover;  ///< CV_32F, noise
    cv::Mat hills;  ///< one row around the horizon, tangent of the skyline's elevation
};

Clouds makeClouds(unsigned seed) {
    cv::RNG rng(seed);
    Clouds clouds;
    clouds.cover =
        noiseField({kCloudPx, kCloudPx}, {.widest_px = 160.0, .octaves = 7, .persistence = 0.55}, rng);
    cv::Mat skyline = noiseField({2048, 1}, {.widest_px = 300.0, .octaves = 5, .persistence = 0.45}, rng);
    clouds.hills = 0.045 + 0.02 * skyline;
    return clouds;
}

float coverAt(const Clouds& clouds, float x, float y) {
    const auto wrapped = [](float value) {
        const float turn = value / 2.0F - std::floor(value / 2.0F);
        const float folded = turn < 0.5F ? 2.0F * turn : 2.0F - 2.0F * turn;  // mirrored: no seam
        return std::min(static_cast<int>(folded * kCloudPx), kCloudPx - 1);
    };
    return clouds.cover.at<float>(wrapped(y), wrapped(x));
}

cv::Vec3b blend(const cv::Scalar& a, const cv::Scalar& b, double share) {
    const cv::Scalar mixed = a * (1.0 - share) + b * share;
    return {static_cast<uchar>(mixed[0]), static_cast<uchar>(mixed[1]), static_cast<uchar>(mixed[2])};
}

cv::Vec3b skyColour(const Clouds& clouds, const Eigen::Vector3f& along) {
    const float slope = along.z() / std::hypot(along.x(), along.y());
    const float turn = std::atan2(along.x(), along.y()) / (2.0F * static_cast<float>(CV_PI)) + 0.5F;
    const float folded = turn < 0.5F ? 2.0F * turn : 2.0F - 2.0F * turn;
    const float skyline = clouds.hills.at<float>(0, std::min(static_cast<int>(folded * 2048.0F), 2047));
    if (slope < skyline) {
        const double near = std::clamp((skyline - slope) * 6.0, 0.0, 1.0);
        return blend({158, 146, 128}, {86, 104, 88}, near);
    }
    const double height = std::min(1.0, static_cast<double>(slope));
    const cv::Vec3b blue = blend(kHaze, {212, 158, 104}, std::sqrt(height));
    const float lift = along.z() + 0.12F;
    const float cover = coverAt(clouds, 0.35F * along.x() / lift + 0.3F, 0.35F * along.y() / lift + 0.4F);
    const double cloud = std::clamp((cover + 0.1) * 0.8, 0.0, 1.0) * std::clamp(slope * 5.0, 0.35, 1.0);
    const double white = std::clamp(1.0 - 0.10 * (cover - 0.8), 0.82, 1.0);
    return blend(cv::Scalar(blue[0], blue[1], blue[2]), cv::Scalar(250, 247, 244) * white, cloud);
}

Panel face(const Clouds& clouds, const Eigen::Vector3d& middle, const Eigen::Vector3d& right, int size_px) {
    const Eigen::Vector3d up = right.cross(middle);
    cv::Mat texture(size_px, size_px, CV_8UC3);
    for (int row = 0; row < size_px; ++row) {
        const double v = 1.0 - 2.0 * (row + 0.5) / size_px;
        for (int col = 0; col < size_px; ++col) {
            const double u = 2.0 * (col + 0.5) / size_px - 1.0;
            const Eigen::Vector3f along = (middle + u * right + v * up).normalized().cast<float>();
            texture.at<cv::Vec3b>(row, col) = skyColour(clouds, along);
        }
    }
    return {.name = QStringLiteral("sky"),
            .origin_m = middle - right - up,
            .right_m = 2.0 * right,
            .up_m = 2.0 * up,
            .texture = texture};
}

}  // namespace

std::vector<Panel> cloudySky(unsigned seed) {
    const Clouds clouds = makeClouds(seed);
    const Eigen::Vector3d east = Eigen::Vector3d::UnitX();
    const Eigen::Vector3d north = Eigen::Vector3d::UnitY();
    const Eigen::Vector3d zenith = Eigen::Vector3d::UnitZ();
    return {face(clouds, north, east, kFacePx),   face(clouds, east, -north, kFacePx),
            face(clouds, -north, -east, kFacePx), face(clouds, -east, north, kFacePx),
            face(clouds, zenith, east, kFacePx),  face(clouds, -zenith, east, kFacePx / 16)};
}

}  // namespace pmts::simulator
