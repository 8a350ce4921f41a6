#include "pmts/camera/picture_meters.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cstdint>

namespace pmts::camera {
namespace {

constexpr int kStride = 2;
constexpr int kSmallestBox_px = 8;
constexpr double kFlatVariance = 1.0;  // grey values squared: below, a picture is noise or nothing

using Counts = std::array<std::uint32_t, 256>;

Histogram shares(const Counts& counts, double pixels) {
    Histogram histogram{};
    std::ranges::transform(counts, histogram.begin(), [pixels](std::uint32_t count) { return static_cast<float>(count / pixels); });
    return histogram;
}

void countLevels(const cv::Mat& bgr, const cv::Mat& grey, PictureMeters& meters) {
    Counts luma{}, red{}, green{}, blue{};
    std::uint32_t burnt = 0, black = 0, pixels = 0;
    std::uint64_t sum = 0;
    for (int row = 0; row < bgr.rows; row += kStride) {
        const auto* const colours = bgr.ptr<cv::Vec3b>(row);
        const auto* const greys = grey.ptr<std::uint8_t>(row);
        for (int col = 0; col < bgr.cols; col += kStride) {
            const cv::Vec3b& colour = colours[col];
            ++blue[colour[0]];
            ++green[colour[1]];
            ++red[colour[2]];
            ++luma[greys[col]];
            sum += greys[col];
            const int highest = std::max({colour[0], colour[1], colour[2]});
            burnt += highest >= kBurntLevel ? 1U : 0U;
            black += highest <= kBlackLevel ? 1U : 0U;
            ++pixels;
        }
    }
    meters.luma = shares(luma, pixels);
    meters.red = shares(red, pixels);
    meters.green = shares(green, pixels);
    meters.blue = shares(blue, pixels);
    meters.burnt_share = static_cast<double>(burnt) / pixels;
    meters.black_share = static_cast<double>(black) / pixels;
    meters.mean_luma = static_cast<double>(sum) / pixels;
}

double sharpnessOf(const cv::Mat& grey) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(grey, mean, deviation);
    const double variance = deviation[0] * deviation[0];
    if (variance < kFlatVariance) {
        return 0.0;
    }
    cv::Mat across, down;
    cv::Sobel(grey, across, CV_16S, 1, 0, 3, 0.125);
    cv::Sobel(grey, down, CV_16S, 0, 1, 3, 0.125);
    const double energy = across.dot(across) + down.dot(down);
    return 100.0 * energy / static_cast<double>(grey.total()) / variance;
}

}  // namespace

PictureMeters measurePicture(const cv::Mat& bgr, const std::optional<cv::Rect>& box) {
    PictureMeters meters;
    if (bgr.empty() || bgr.type() != CV_8UC3) {
        return meters;
    }
    cv::Mat grey;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    countLevels(bgr, grey, meters);
    meters.sharpness = sharpnessOf(grey);
    if (box) {
        const cv::Rect inside = *box & cv::Rect(0, 0, bgr.cols, bgr.rows);
        if (inside.width >= kSmallestBox_px && inside.height >= kSmallestBox_px) {
            meters.box_sharpness = sharpnessOf(grey(inside));
        }
    }
    return meters;
}

cv::Mat burntMask(const cv::Mat& bgr) {
    cv::Mat inside, mask;
    constexpr double kMost = kBurntLevel - 1;
    cv::inRange(bgr, cv::Scalar::all(0), cv::Scalar::all(kMost), inside);
    cv::bitwise_not(inside, mask);
    return mask;
}

}  // namespace pmts::camera
