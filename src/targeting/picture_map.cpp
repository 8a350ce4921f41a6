#include "picture_map.hpp"

#include "cubic_sampling.hpp"

#include <Eigen/QR>

#include <cmath>

namespace pmts::targeting {
namespace {

using Terms = Eigen::Matrix<double, 6, 1>;

Terms termsAt(const Eigen::Vector2d& offset) {
    const double x = offset.x();
    const double y = offset.y();
    return (Terms() << 1.0, x, y, x * x, x * y, y * y).finished();
}

}  // namespace

std::optional<PictureMap> PictureMap::fitted(const Expectation& expected, const Eigen::Vector2d& click_px,
                                             double reach_px) {
    constexpr int kSteps = 3;  // 7 x 7 offsets
    constexpr int kFewest = 20;
    Eigen::Matrix<double, Eigen::Dynamic, 6> terms(49, 6);
    Eigen::Matrix<double, Eigen::Dynamic, 2> seen(49, 2);
    int rows = 0;
    for (int row = -kSteps; row <= kSteps; ++row) {
        for (int column = -kSteps; column <= kSteps; ++column) {
            const Eigen::Vector2d unit(static_cast<double>(column) / kSteps,
                                       static_cast<double>(row) / kSteps);
            if (const auto px = expected.seen(click_px + reach_px * unit)) {
                terms.row(rows) = termsAt(unit).transpose();
                seen.row(rows++) = px->transpose();
            }
        }
    }
    if (rows < kFewest) {
        return std::nullopt;
    }
    const Eigen::Matrix<double, 6, 2> solved =
        terms.topRows(rows).colPivHouseholderQr().solve(seen.topRows(rows));
    const double r = reach_px;
    const Terms scale = (Terms() << 1.0, 1 / r, 1 / r, 1 / (r * r), 1 / (r * r), 1 / (r * r)).finished();
    return PictureMap(solved.transpose() * scale.asDiagonal());
}

PictureMap PictureMap::identityAt(const Eigen::Vector2d& click_px) {
    Coefficients coefficients = Coefficients::Zero();
    coefficients.col(0) = click_px;
    coefficients(0, 1) = 1.0;
    coefficients(1, 2) = 1.0;
    return PictureMap(coefficients);
}

Eigen::Vector2d PictureMap::at(const Eigen::Vector2d& offset_px) const {
    return coefficients_ * termsAt(turn_ * offset_px);
}

PictureMap PictureMap::turned(double angle_rad) const {
    const Eigen::Matrix2d turn{{std::cos(angle_rad), -std::sin(angle_rad)},
                               {std::sin(angle_rad), std::cos(angle_rad)}};
    return PictureMap(coefficients_, turn_ * turn);
}

cv::Mat PictureMap::sampled(const cv::Mat& picture, const cv::Rect& offsets, double step_px) const {
    cv::Mat places(offsets.size(), CV_32FC2);
    for (int row = 0; row < places.rows; ++row) {
        for (int column = 0; column < places.cols; ++column) {
            const Eigen::Vector2d px = at(step_px * Eigen::Vector2d(offsets.x + column, offsets.y + row));
            places.at<cv::Vec2f>(row, column) = {static_cast<float>(px.x()), static_cast<float>(px.y())};
        }
    }
    return cubicSampled(picture, places);
}

}  // namespace pmts::targeting
