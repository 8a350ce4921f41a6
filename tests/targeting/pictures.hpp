#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace pmts::test {

/// A picture with detail of every size, like stone or foliage; grey in three channels, larger than asked for
/// so that warps have something to draw from.
inline cv::Mat naturalTexture(cv::Size size, unsigned seed) {
    cv::RNG random(seed);
    cv::Mat sum(size, CV_32F, cv::Scalar(120));
    for (int octave = 0; octave < 6; ++octave) {
        const int step = 2 << octave;
        cv::Mat noise(size.height / step + 2, size.width / step + 2, CV_32F);
        random.fill(noise, cv::RNG::NORMAL, 0.0, 7.0 + 2.0 * octave);
        cv::Mat grown;
        cv::resize(noise, grown, {}, step, step, cv::INTER_CUBIC);
        sum += grown(cv::Rect({0, 0}, size));
    }
    cv::Mat grey, picture;
    sum.convertTo(grey, CV_8U);
    cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
    return picture;
}

/// The picture turned about `centre` and then shifted: new = turn (old - centre) + centre + shift.
struct TurnedPicture {
    double turn_deg = 0.0;
    Eigen::Vector2d shift_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d centre_px{320, 240};

    [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& old_px) const {
        const double a = turn_deg * CV_PI / 180;
        const Eigen::Matrix2d turn{{std::cos(a), -std::sin(a)}, {std::sin(a), std::cos(a)}};
        return turn * (old_px - centre_px) + centre_px + shift_px;
    }
    [[nodiscard]] cv::Mat of(const cv::Mat& old) const {
        const Eigen::Vector2d corner = at({0, 0});
        const Eigen::Vector2d x = at({1, 0}) - corner;
        const Eigen::Vector2d y = at({0, 1}) - corner;
        const cv::Matx23d map(x.x(), y.x(), corner.x(), x.y(), y.y(), corner.y());
        cv::Mat turned;
        cv::warpAffine(old, turned, map, old.size(), cv::INTER_LANCZOS4, cv::BORDER_REFLECT_101);
        return turned;
    }
};

/// What a camera does to a picture between two frames.
inline cv::Mat seenBy(cv::Mat picture, double contrast, double brightness, double blur_px, double noise_grey,
                      unsigned seed) {
    if (blur_px > 0) {
        cv::GaussianBlur(picture, picture, {}, blur_px);
    }
    cv::Mat values, noise(picture.size(), CV_32FC3);
    picture.convertTo(values, CV_32FC3, contrast, brightness);
    cv::RNG(seed).fill(noise, cv::RNG::NORMAL, 0.0, noise_grey);
    cv::Mat seen;
    cv::Mat(values + noise).convertTo(seen, CV_8UC3);
    return seen;
}

/// A wall of equal windows, exactly repeated every `pitch_px`.
inline cv::Mat facadeOfWindows(cv::Size size, int pitch_px) {
    cv::Mat facade(size, CV_8UC3, cv::Scalar(150, 170, 190));
    for (int y = pitch_px / 4; y < size.height; y += pitch_px) {
        for (int x = pitch_px / 4; x < size.width; x += pitch_px) {
            cv::rectangle(facade, {x, y, pitch_px / 2, 2 * pitch_px / 3}, {60, 55, 50}, cv::FILLED);
            cv::rectangle(facade, {x, y, pitch_px / 2, 2 * pitch_px / 3}, {230, 230, 230}, 2);
            cv::line(facade, {x + pitch_px / 4, y}, {x + pitch_px / 4, y + 2 * pitch_px / 3}, {230, 230, 230},
                     2);
        }
    }
    return facade;
}

}  // namespace pmts::test
