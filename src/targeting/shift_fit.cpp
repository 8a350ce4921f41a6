#include "shift_fit.hpp"

#include "cubic_sampling.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pmts::targeting {
namespace {

using Unknowns = Eigen::Matrix<double, 8, 1>;  // shift x y, turn xx xy yx yy, gain, offset
using Normal = Eigen::Matrix<double, 8, 8>;

/// A patch is turned, scaled or sheared against the rig model's expectation by no more than this (one sigma):
/// where the texture does not say, the model does.
constexpr double kDeformation = 0.015;

/// Smoothing in both pictures makes neighbouring grey values' noise alike: fewer of them are independent.
constexpr double kCorrelatedNoise = 2.0;

struct Gradients {
    cv::Mat x, y;
    explicit Gradients(const cv::Mat& grey) {
        cv::Scharr(grey, x, CV_32F, 1, 0, 1.0 / 32);
        cv::Scharr(grey, y, CV_32F, 0, 1, 1.0 / 32);
    }
};

/// The window as the patch sees it through the warp.
cv::Mat seenThrough(const PatchWarp& warp, const cv::Mat& window, cv::Size size, const cv::Point2d& click) {
    cv::Mat places(size, CV_32FC2);
    for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
            const Eigen::Vector2d px = warp.turn * Eigen::Vector2d(column - click.x, row - click.y) + warp.at;
            places.at<cv::Vec2f>(row, column) = {static_cast<float>(px.x()), static_cast<float>(px.y())};
        }
    }
    return cubicSampled(window, places);
}

/// What one part of the patch says about a shift of its own.
struct PartOfPatch {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    double weights = 0.0, residuals2 = 0.0;

    void add(const Eigen::Vector2d& gradient, double residual, double weight) {
        normal += weight * gradient * gradient.transpose();
        right += weight * residual * gradient;
        weights += weight;
        residuals2 += weight * residual * residual;
    }
    /// Along each of its two axes of certainty: the shift it wants, less three sigma.
    [[nodiscard]] double unrest_px() const {
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(normal);
        double most = 0.0;
        for (int axis = 0; axis < 2; ++axis) {
            const double certainty = std::max(axes.eigenvalues()(axis), 1e-6);
            const double shift = std::abs(axes.eigenvectors().col(axis).dot(right)) / certainty;
            const double sigma =
                kCorrelatedNoise * std::sqrt(residuals2 / std::max(weights, 1.0) / certainty);
            most = std::max(most, std::min(shift, 5.0) - 3.0 * sigma);
        }
        return most;
    }
};

/// One linearised adjustment.
struct Adjustment {
    Normal normal = Normal::Zero();
    Unknowns right = Unknowns::Zero();
    double weights = 0.0;
    double residuals2 = 0.0;           ///< weighted sum of squares before the step
    std::vector<float> sizes;          ///< of the residuals
    std::array<PartOfPatch, 4> parts;  ///< right, left, lower, upper

    [[nodiscard]] double unrest_px() const {
        double most = 0.0;
        for (const PartOfPatch& part : parts) {
            most = std::max(most, part.unrest_px());
        }
        return most;
    }

    /// `deformed` is what the warp has beyond its start; `sigma_grey` weighs grey values against it.
    void addPrior(const Eigen::Vector4d& deformed, double sigma_grey) {
        const double weight = std::pow(sigma_grey / kDeformation, 2);
        normal.diagonal().segment<4>(2).array() += weight;
        right.segment<4>(2) -= weight * deformed;
    }
    [[nodiscard]] Eigen::Matrix2d shiftCofactors() const {
        const Eigen::LDLT<Normal> solver(normal.selfadjointView<Eigen::Lower>());
        return solver.solve(Normal::Identity()).topLeftCorner<2, 2>();
    }
    void add(const Unknowns& terms, double residual, double weight) {
        normal.selfadjointView<Eigen::Lower>().rankUpdate(terms, weight);
        right += weight * residual * terms;
        weights += weight;
        residuals2 += weight * residual * residual;
    }
};

double tukey(double residual, double scale) {
    const double u = residual / (6.0 * scale);
    return std::abs(u) >= 1.0 ? 0.0 : std::pow(1.0 - u * u, 2);
}

Adjustment adjusted(const cv::Mat& patch, const cv::Mat& seen, const cv::Mat& weights,
                    const cv::Point2d& click, double gain, double offset, double scale) {
    const Gradients gradients(seen);
    Adjustment sums;
    sums.sizes.reserve(patch.total());
    for (int row = 1; row + 1 < patch.rows; ++row) {
        for (int column = 1; column + 1 < patch.cols; ++column) {
            const double gx = gain * gradients.x.at<float>(row, column);
            const double gy = gain * gradients.y.at<float>(row, column);
            const double x = column - click.x;
            const double y = row - click.y;
            const double grey = seen.at<float>(row, column);
            const double residual = patch.at<float>(row, column) - (gain * grey + offset);
            const Unknowns terms =
                (Unknowns() << gx, gy, gx * x, gx * y, gy * x, gy * y, grey, 1.0).finished();
            const double weight = weights.at<float>(row, column) * tukey(residual, scale);
            sums.add(terms, residual, weight);
            const std::size_t sector = std::abs(x) > std::abs(y) ? (x > 0 ? 0 : 1) : (y > 0 ? 2 : 3);
            sums.parts[sector].add({gx, gy}, residual, weight);
            sums.sizes.push_back(static_cast<float>(std::abs(residual)));
        }
    }
    return sums;
}

double medianOf(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double weakest(const Eigen::Matrix2d& covariance) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance, Eigen::EigenvaluesOnly);
    return std::max(axes.eigenvalues()(1), 0.0);
}

/// Gain and offset that make the seen grey values like the patch's.
std::pair<double, double> tone(const cv::Mat& patch, const cv::Mat& seen) {
    cv::Scalar patch_mean, patch_deviation, seen_mean, seen_deviation;
    cv::meanStdDev(patch, patch_mean, patch_deviation);
    cv::meanStdDev(seen, seen_mean, seen_deviation);
    const double gain = patch_deviation[0] / std::max(seen_deviation[0], 1e-3);
    return {gain, patch_mean[0] - gain * seen_mean[0]};
}

double correlation(const cv::Mat& patch, const cv::Mat& seen, const cv::Mat& weights) {
    const double total = cv::sum(weights)[0];
    const cv::Mat a = patch - patch.dot(weights) / total;
    const cv::Mat b = seen - seen.dot(weights) / total;
    const cv::Mat weighted_a = a.mul(weights);
    return weighted_a.dot(b) / std::sqrt(std::max(weighted_a.dot(a) * b.mul(weights).dot(b), 1e-12));
}

void describe(ShiftFit& fit, const Adjustment& sums) {
    const double variance = sums.residuals2 / std::max(sums.weights - 8.0, 1.0);
    const Eigen::Matrix2d deformed = fit.warp.turn - Eigen::Matrix2d::Identity();
    fit.sigma_px = kCorrelatedNoise * std::sqrt(variance * weakest(sums.shiftCofactors()));
    fit.unrest_px = sums.unrest_px();
    fit.deformation = deformed.cwiseAbs().maxCoeff();
}

}  // namespace

cv::Mat bellWeights(cv::Size size, const cv::Point2d& click, double half_px) {
    cv::Mat weights(size, CV_32F);
    for (int row = 0; row < size.height; ++row) {
        for (int column = 0; column < size.width; ++column) {
            const double r2 =
                std::pow((column - click.x) / half_px, 2) + std::pow((row - click.y) / half_px, 2);
            weights.at<float>(row, column) = static_cast<float>(std::exp(-2.0 * r2));
        }
    }
    return weights;
}

double expectedSigma_px(const cv::Mat& patch, const cv::Point2d& click, const cv::Mat& weights,
                        double noise_grey) {
    constexpr double kSmoothed = 0.28;  // of white noise after the matcher's smoothing
    const double sigma_grey = kCorrelatedNoise * kSmoothed * std::sqrt(2.0) * noise_grey;
    Adjustment sums = adjusted(patch, patch, weights, click, 1.0, 0.0, 1e3);
    sums.addPrior(Eigen::Vector4d::Zero(), sigma_grey);
    return sigma_grey * std::sqrt(weakest(sums.shiftCofactors()));
}

std::optional<ShiftFit> fitShift(const cv::Mat& patch, const cv::Point2d& click, const cv::Mat& weights,
                                 const cv::Mat& window, const PatchWarp& start) {
    constexpr int kMostSteps = 20;
    constexpr int kScaleSteps = 4;  // then what is an outlier stays one
    constexpr double kSettled_px = 2e-3;
    constexpr double kNearlySettled_px = 0.02;
    constexpr double kStrayed_px = 3.0;
    ShiftFit fit{.warp = start};
    cv::Mat seen = seenThrough(fit.warp, window, patch.size(), click);
    auto [gain, offset] = tone(patch, seen);
    double scale = 1e3;  // the first step trusts everything
    constexpr double kFirstScale = 5.0;
    for (int step = 0; step < kMostSteps; ++step) {
        Adjustment sums = adjusted(patch, seen, weights, click, gain, offset, scale);
        const Eigen::Matrix2d beyond = start.turn.inverse() * fit.warp.turn - Eigen::Matrix2d::Identity();
        sums.addPrior({beyond(0, 0), beyond(0, 1), beyond(1, 0), beyond(1, 1)},
                      kCorrelatedNoise * std::min(scale, kFirstScale));
        const Eigen::LDLT<Normal> solver(sums.normal.selfadjointView<Eigen::Lower>());
        const Unknowns change = solver.solve(sums.right);
        if (solver.info() != Eigen::Success || !change.allFinite()) {
            return std::nullopt;
        }
        const Eigen::Matrix2d turn{{change(2), change(3)}, {change(4), change(5)}};
        fit.warp.at += fit.warp.turn * change.head<2>();
        fit.warp.turn = fit.warp.turn * (Eigen::Matrix2d::Identity() + turn);
        gain += change(6);
        offset += change(7);
        if (step < kScaleSteps) {
            scale = std::max(1.4826 * medianOf(sums.sizes), 0.5);
        }
        seen = seenThrough(fit.warp, window, patch.size(), click);
        if ((fit.warp.at - start.at).norm() > kStrayed_px) {
            return std::nullopt;
        }
        const double enough_px = step + 1 < kMostSteps ? kSettled_px : kNearlySettled_px;
        if (step >= 2 && change.head<2>().norm() < enough_px) {
            fit.score = correlation(patch, seen, weights);
            fit.kept = sums.weights / cv::sum(weights)[0];
            describe(fit, sums);
            return fit;
        }
    }
    return std::nullopt;
}

}  // namespace pmts::targeting
