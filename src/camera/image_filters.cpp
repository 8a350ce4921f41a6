#include "pmts/camera/image_filters.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace pmts::camera {
namespace {

constexpr int kRed = 2;  ///< place of red in BGR

cv::Mat mixed(const cv::Mat& before, const cv::Mat& after, double strength) {
    cv::Mat result;
    const double share = std::clamp(strength, 0.0, 1.0);
    cv::addWeighted(before, 1.0 - share, after, share, 0.0, result);
    return result;
}

/// Shifts the values until their mean is as it was; a few rounds because the ends are cut off.
void keepMean(cv::Mat& values, double mean) {
    for (int round = 0; round < 4; ++round) {
        values.convertTo(values, -1, 1.0, mean - cv::mean(values)[0]);
    }
}

}  // namespace

cv::Mat smoothed(const cv::Mat& bgr, double strength) {
    constexpr double kClip = 10.0;
    constexpr int kTiles = 8;
    cv::Mat lab;
    cv::cvtColor(bgr, lab, cv::COLOR_BGR2Lab);
    std::vector<cv::Mat> planes;
    cv::split(lab, planes);
    cv::Mat balanced;
    cv::createCLAHE(kClip, {kTiles, kTiles})->apply(planes[0], balanced);
    keepMean(balanced, cv::mean(planes[0])[0]);
    planes[0] = mixed(planes[0], balanced, strength);
    cv::merge(planes, lab);
    cv::Mat result;
    cv::cvtColor(lab, result, cv::COLOR_Lab2BGR);
    return result;
}

cv::Mat sharpened(const cv::Mat& bgr, double strength) {
    constexpr double kRadius_px = 1.5;
    constexpr double kStrongest = 2.0;
    cv::Mat blurred;
    cv::GaussianBlur(bgr, blurred, {}, kRadius_px);
    const double gain = kStrongest * std::clamp(strength, 0.0, 1.0);
    cv::Mat result;
    cv::addWeighted(bgr, 1.0 + gain, blurred, -gain, 0.0, result);
    return result;
}

cv::Mat edgesOf(const cv::Mat& bgr, double strength) {
    constexpr double kBlur_px = 1.0;
    constexpr double kContrast = 0.5;  ///< a step of 128 grey values is drawn black
    cv::Mat grey;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    cv::GaussianBlur(grey, grey, {}, kBlur_px);
    cv::Mat across;
    cv::Mat down;
    cv::Mat size;
    cv::Sobel(grey, across, CV_32F, 1, 0);
    cv::Sobel(grey, down, CV_32F, 0, 1);
    cv::magnitude(across, down, size);
    cv::Mat drawn;
    size.convertTo(drawn, CV_8U, -kContrast, 255.0);
    cv::cvtColor(drawn, drawn, cv::COLOR_GRAY2BGR);
    return mixed(bgr, drawn, strength);
}

cv::Mat bandsOf(const cv::Mat& bgr, const ImageFilter& filter) {
    std::vector<cv::Mat> planes;
    cv::split(bgr, planes);
    const std::array<double, 3> gains{filter.blue, filter.green, filter.red};
    for (std::size_t i = 0; i < planes.size() && i < gains.size(); ++i) {
        planes[i].convertTo(planes[i], -1, gains[i]);
    }
    cv::Mat result;
    if (filter.single_band) {
        const auto band = static_cast<std::size_t>(std::clamp(kRed - filter.band, 0, kRed));
        cv::cvtColor(planes[band], result, cv::COLOR_GRAY2BGR);
    } else {
        cv::merge(planes, result);
    }
    return result;
}

cv::Mat filtered(const cv::Mat& bgr, const ImageFilter& filter) {
    if (filter.isNone() || bgr.empty() || bgr.type() != CV_8UC3) {
        return bgr;
    }
    cv::Mat result = bandsOf(bgr, filter);
    if (filter.smooth > 0) {
        result = smoothed(result, filter.smooth);
    }
    if (filter.sharp > 0) {
        result = sharpened(result, filter.sharp);
    }
    return filter.edges > 0 ? edgesOf(result, filter.edges) : result;
}

}  // namespace pmts::camera
