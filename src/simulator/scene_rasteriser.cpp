#include "scene_rasteriser.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmts::simulator {
namespace {

constexpr int kGridPx = 8;
constexpr int kBandRows = 32;  // stays in the cache, and small enough for remap() to keep to this thread
constexpr int kRunPx = 32;     // one texture level for a run of pixels
constexpr int kNobody = -1;
constexpr float kTexelsPerPixel = 1.25F;
constexpr int kSteps = cv::INTER_TAB_SIZE;  // remap's own fractions of a texel
constexpr auto kStepsF = static_cast<float>(kSteps);

cv::Vec2f ray(const camera::Lens& lens, double u, double v) {
    const auto along = lens.cameraFromPixel({u, v});
    if (!along || along->z() < 1e-3) {
        constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
        return {kNone, kNone};
    }
    return {static_cast<float>(along->x() / along->z()), static_cast<float>(along->y() / along->z())};
}

cv::Mat coarseRays(const camera::Rig& rig) {
    cv::Mat coarse((rig.height_px - 1) / kGridPx + 2, (rig.width_px - 1) / kGridPx + 2, CV_32FC2);
    for (int row = 0; row < coarse.rows; ++row) {
        for (int col = 0; col < coarse.cols; ++col) {
            coarse.at<cv::Vec2f>(row, col) = ray(rig.lens, col * kGridPx, row * kGridPx);
        }
    }
    return coarse;
}

}  // namespace

RayTable RayTable::of(const camera::Rig& rig) {
    const cv::Mat coarse = coarseRays(rig);
    RayTable rays{cv::Mat(rig.height_px, rig.width_px, CV_32F), cv::Mat(rig.height_px, rig.width_px, CV_32F)};
    for (int row = 0; row < rig.height_px; ++row) {
        const float down = static_cast<float>(row % kGridPx) / kGridPx;
        const auto* above = coarse.ptr<cv::Vec2f>(row / kGridPx);
        const auto* below = coarse.ptr<cv::Vec2f>(row / kGridPx + 1);
        for (int col = 0; col < rig.width_px; ++col) {
            const int cell = col / kGridPx;
            const float right = static_cast<float>(col % kGridPx) / kGridPx;
            const cv::Vec2f left_side = above[cell] * (1.0F - down) + below[cell] * down;
            const cv::Vec2f right_side = above[cell + 1] * (1.0F - down) + below[cell + 1] * down;
            const cv::Vec2f here = left_side * (1.0F - right) + right_side * right;
            rays.x.at<float>(row, col) = here[0];
            rays.y.at<float>(row, col) = here[1];
        }
    }
    return rays;
}

SceneRasteriser::SceneRasteriser(const TextureAtlas& atlas, RayTable rays)
    : atlas_(atlas),
      rays_(std::move(rays)),
      nearest_(kBandRows, rays_.x.cols, CV_32F),
      owner_(kBandRows, rays_.x.cols, CV_32S),
      map_xy_(kBandRows, rays_.x.cols, CV_16SC2),
      map_fraction_(kBandRows, rays_.x.cols, CV_16UC1) {
    const int row = rays_.x.rows / 2;
    const int col = rays_.x.cols / 2;
    rays_per_pixel_ = std::abs(rays_.x.at<float>(row, col) - rays_.x.at<float>(row, col - 1));
}

void SceneRasteriser::draw(const std::vector<ScenePatch>& patches, cv::Mat& image) {
    image.create(rays_.x.size(), CV_8UC3);
    for (int first = 0; first < image.rows; first += kBandRows) {
        const int last = std::min(first + kBandRows, image.rows);
        findNearest(patches, first, last);
        fillMaps(patches, first, last);
        const cv::Range band(0, last - first);
        cv::Mat rows = image.rowRange(first, last);
        cv::remap(atlas_.image(), rows, map_xy_.rowRange(band), map_fraction_.rowRange(band),
                  cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    }
}

/// Branch-free inside, so that the compiler does four pixels at once: no division, only products and
/// comparisons.
void SceneRasteriser::findNearest(const std::vector<ScenePatch>& patches, int first_row, int last_row) {
    nearest_.setTo(0.0F);
    owner_.setTo(kNobody);
    for (std::size_t index = 0; index < patches.size(); ++index) {
        const Eigen::Matrix3f m = patches[index].patch_from_ray;
        const float m00 = m(0, 0), m10 = m(1, 0), m20 = m(2, 0);
        const cv::Rect bounds = patches[index].bounds;
        const int id = static_cast<int>(index);
        const int end = std::min(last_row, bounds.br().y);
        for (int row = std::max(first_row, bounds.y); row < end; ++row) {
            const float* __restrict x = rays_.x.ptr<float>(row) + bounds.x;
            const float* __restrict y = rays_.y.ptr<float>(row) + bounds.x;
            float* __restrict nearest = nearest_.ptr<float>(row - first_row) + bounds.x;
            int* __restrict owner = owner_.ptr<int>(row - first_row) + bounds.x;
            for (int i = 0; i < bounds.width; ++i) {
                const float a = m00 * x[i] + m(0, 1) * y[i] + m(0, 2);
                const float b = m10 * x[i] + m(1, 1) * y[i] + m(1, 2);
                const float c = m20 * x[i] + m(2, 1) * y[i] + m(2, 2);
                const bool seen = (a >= 0.0F) & (a <= c) & (b >= 0.0F) & (b <= c) & (c > nearest[i]);
                nearest[i] = seen ? c : nearest[i];
                owner[i] = seen ? id : owner[i];
            }
        }
    }
}

void SceneRasteriser::fillMaps(const std::vector<ScenePatch>& patches, int first_row, int last_row) {
    const int width = owner_.cols;
    for (int row = first_row; row < last_row; ++row) {
        const int band_row = row - first_row;
        const int* owner = owner_.ptr<int>(band_row);
        for (int begin = 0; begin < width;) {
            int end = begin + 1;
            while (end < width && end - begin < kRunPx && owner[end] == owner[begin]) {
                ++end;
            }
            if (owner[begin] == kNobody) {
                std::fill(map_xy_.ptr<cv::Vec2s>(band_row) + begin, map_xy_.ptr<cv::Vec2s>(band_row) + end,
                          cv::Vec2s(0, 0));
                std::fill(map_fraction_.ptr<ushort>(band_row) + begin,
                          map_fraction_.ptr<ushort>(band_row) + end, ushort{0});
            } else {
                mapRun(patches[static_cast<std::size_t>(owner[begin])], row, band_row, begin, end);
            }
            begin = end;
        }
    }
}

namespace {

/// The level whose texels are about a pixel here: texels per pixel across and along, their geometric mean.
const cv::Rect& levelFor(const TextureAtlas::Levels& levels, const Eigen::Matrix3f& m,
                         const Eigen::Vector3f& abc, float rays_per_pixel) {
    const auto width = static_cast<float>(levels.front().width);
    const auto height = static_cast<float>(levels.front().height);
    const float inverse = rays_per_pixel / abc.z();
    const auto step = [&](int axis) {
        const float du = width * (m(0, axis) - abc.x() / abc.z() * m(2, axis)) * inverse;
        const float dv = height * (m(1, axis) - abc.y() / abc.z() * m(2, axis)) * inverse;
        return du * du + dv * dv;
    };
    float squared = std::sqrt(step(0) * step(1));
    std::size_t level = 0;
    while (squared > kTexelsPerPixel * kTexelsPerPixel && level + 1 < levels.size()) {
        squared /= 4.0F;
        ++level;
    }
    return levels[level];
}

}  // namespace

void SceneRasteriser::mapRun(const ScenePatch& patch, int row, int band_row, int begin, int end) {
    const Eigen::Matrix3f m = patch.patch_from_ray;
    const float* __restrict x = rays_.x.ptr<float>(row);
    const float* __restrict y = rays_.y.ptr<float>(row);
    const int middle = (begin + end) / 2;
    const Eigen::Vector3f abc = m * Eigen::Vector3f(x[middle], y[middle], 1.0F);
    const cv::Rect place = levelFor(atlas_.levels(patch.texture), m, abc, rays_per_pixel_);
    // A texel's centre is at half a texel; the last half rounds.
    const auto width = static_cast<float>(place.width) * kStepsF;
    const auto height = static_cast<float>(place.height) * kStepsF;
    const float left = (static_cast<float>(place.x) - 0.5F) * kStepsF + 0.5F;
    const float top = (static_cast<float>(place.y) - 0.5F) * kStepsF + 0.5F;
    short* __restrict xy = map_xy_.ptr<short>(band_row);
    ushort* __restrict fraction = map_fraction_.ptr<ushort>(band_row);
    for (int i = begin; i < end; ++i) {
        const float inverse = 1.0F / (m(2, 0) * x[i] + m(2, 1) * y[i] + m(2, 2));
        const float a = m(0, 0) * x[i] + m(0, 1) * y[i] + m(0, 2);
        const float b = m(1, 0) * x[i] + m(1, 1) * y[i] + m(1, 2);
        const int u = static_cast<int>(left + width * a * inverse);
        const int v = static_cast<int>(top + height * b * inverse);
        xy[2 * i] = static_cast<short>(u >> cv::INTER_BITS);
        xy[2 * i + 1] = static_cast<short>(v >> cv::INTER_BITS);
        fraction[i] = static_cast<ushort>((v & (kSteps - 1)) * kSteps + (u & (kSteps - 1)));
    }
}

}  // namespace pmts::simulator
