#include "scene_noise.hpp"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <vector>

namespace pmts::simulator {
namespace {

constexpr int kTilePx = 1024;

cv::Mat octave(cv::Size size, double blotch_px, cv::RNG& rng) {
    if (blotch_px <= 1.5) {
        cv::Mat grain(size, CV_32F);
        rng.fill(grain, cv::RNG::UNIFORM, -1.7, 1.7);
        return grain;
    }
    const cv::Size coarse(static_cast<int>(size.width / blotch_px) + 3,
                          static_cast<int>(size.height / blotch_px) + 3);
    cv::Mat knots(coarse, CV_32F);
    rng.fill(knots, cv::RNG::NORMAL, 0.0, 1.3);  // smoothing takes some of it away again
    cv::Mat smooth;
    cv::resize(knots, smooth, size, 0, 0, blotch_px < 3.0 ? cv::INTER_LINEAR : cv::INTER_CUBIC);
    return smooth;
}

cv::Mat makeTile(const NoiseShape& shape, unsigned seed) {
    cv::RNG rng(seed);
    cv::Mat tile;
    noiseField({kTilePx, kTilePx}, shape, rng).convertTo(tile, CV_8S, 32.0);
    return tile;
}

const cv::Mat& tileOf(Grain grain) {
    static const cv::Mat blotches = makeTile({.widest_px = 110.0, .octaves = 5}, 101);
    static const cv::Mat fine = makeTile({.widest_px = 6.0, .octaves = 3, .persistence = 0.8}, 102);
    return grain == Grain::kBlotches ? blotches : fine;
}

}  // namespace

cv::Mat noiseField(cv::Size size, const NoiseShape& shape, cv::RNG& rng) {
    cv::Mat sum = cv::Mat::zeros(size, CV_32F);
    double strength = 1.0;
    double power = 0.0;
    double blotch_px = shape.widest_px;
    for (int i = 0; i < shape.octaves && blotch_px >= 1.0; ++i) {
        cv::scaleAdd(octave(size, blotch_px, rng), strength, sum, sum);
        power += strength * strength;
        strength *= shape.persistence;
        blotch_px /= 2.0;
    }
    sum *= 1.0 / std::sqrt(std::max(power, 1e-9));
    return sum;
}

GrainPatch::GrainPatch(Grain grain, double zoom, cv::RNG& rng)
    : tile_(tileOf(grain)),
      offset_(rng.uniform(0, 2 * kTilePx), rng.uniform(0, 2 * kTilePx)),
      step_q8_(std::max(16, cvRound(zoom * 256))) {}

void shadeBy(cv::Mat& image, const GrainPatch& grain, double strength, double light) {
    constexpr int kShift = 12;
    const int base = cvRound(light * (1 << kShift));
    const int slope = cvRound(light * strength / 32.0 * (1 << kShift));
    std::vector<int> columns(static_cast<std::size_t>(image.cols));
    for (int col = 0; col < image.cols; ++col) {
        columns[static_cast<std::size_t>(col)] = grain.column(col);
    }
    for (int row = 0; row < image.rows; ++row) {
        uchar* __restrict pixel = image.ptr(row);
        const schar* __restrict shade = grain.row(row);
        for (int col = 0; col < image.cols; ++col) {
            const int factor = std::max(0, base + slope * shade[columns[static_cast<std::size_t>(col)]]);
            for (int channel = 0; channel < 3; ++channel) {
                pixel[3 * col + channel] =
                    static_cast<uchar>(std::min(255, (pixel[3 * col + channel] * factor) >> kShift));
            }
        }
    }
}

}  // namespace pmts::simulator
