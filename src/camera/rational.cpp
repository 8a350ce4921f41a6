#include "rational.hpp"

#include "radial_roots.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::camera::rational {
namespace {

/// Past this x2 + y2 the leading terms decide: an angle within 0.1 mrad of 100 gon.
constexpr double kLastR2 = 1e8;

double numerator(const RationalLens& lens, double r2) {
    return 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
}

double denominator(const RationalLens& lens, double r2) {
    return 1 + r2 * (lens.k4 + r2 * (lens.k5 + r2 * lens.k6));
}

double radialFactor(const RationalLens& lens, double r2) {
    return numerator(lens, r2) / denominator(lens, r2);
}

/// d factor / d r2.
double factorSlope(const RationalLens& lens, double r2) {
    const double below = denominator(lens, r2);
    const double numerator_slope = lens.k1 + r2 * (2 * lens.k2 + r2 * 3 * lens.k3);
    const double denominator_slope = lens.k4 + r2 * (2 * lens.k5 + r2 * 3 * lens.k6);
    return (numerator_slope - numerator(lens, r2) / below * denominator_slope) / below;
}

/// Numerator of d/dr of r N(s) / D(s), a polynomial in s = r2: (N + 2 s N') D - 2 s N D'.
std::vector<double> radialGrowth(const RationalLens& lens) {
    const std::array n{1.0, lens.k1, lens.k2, lens.k3};
    const std::array d{1.0, lens.k4, lens.k5, lens.k6};
    std::vector<double> growth(7, 0.0);
    for (std::size_t i = 0; i < n.size(); ++i) {
        for (std::size_t j = 0; j < d.size(); ++j) {
            growth[i + j] +=
                n[i] * d[j] * (1.0 + 2.0 * static_cast<double>(i) - 2.0 * static_cast<double>(j));
        }
    }
    return growth;
}

Eigen::Vector2d bent(const RationalLens& lens, const Eigen::Vector2d& xy) {
    const double x = xy.x();
    const double y = xy.y();
    const double r2 = xy.squaredNorm();
    return radialFactor(lens, r2) * xy + Eigen::Vector2d(2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x),
                                                         lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y);
}

Eigen::Matrix2d jacobian(const RationalLens& lens, const Eigen::Vector2d& xy) {
    const double x = xy.x();
    const double y = xy.y();
    const double r2 = xy.squaredNorm();
    const double slope = 2 * factorSlope(lens, r2);  // d factor / d r, over r
    Eigen::Matrix2d j = radialFactor(lens, r2) * Eigen::Matrix2d::Identity() + slope * xy * xy.transpose();
    j(0, 0) += 2 * lens.p1 * y + 6 * lens.p2 * x;
    j(0, 1) += 2 * lens.p1 * x + 2 * lens.p2 * y;
    j(1, 0) += 2 * lens.p1 * x + 2 * lens.p2 * y;
    j(1, 1) += 6 * lens.p1 * y + 2 * lens.p2 * x;
    return j;
}

bool unfolded(const RationalLens& lens, double fold_r2, const Eigen::Vector2d& xy) {
    return xy.allFinite() && xy.squaredNorm() <= fold_r2 && jacobian(lens, xy).determinant() > 0;
}

/// Radius whose radially distorted length is `wanted`, or the fold when it is never that long: a bisection.
double radialStart(const RationalLens& lens, double fold_r2, double wanted) {
    double low = 0;
    double high = std::isfinite(fold_r2) ? std::sqrt(fold_r2) : std::max(1.0, wanted);
    constexpr int kDoublings = 64;  // a fold beyond every real angle would let the search run on for ever
    for (int i = 0;
         i < kDoublings && !std::isfinite(fold_r2) && high * radialFactor(lens, high * high) < wanted; ++i) {
        high *= 2;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (middle * radialFactor(lens, middle * middle) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

RationalLens asRational(const BrownLens& lens) {
    return {.f_px = lens.f_px,
            .cx_px = lens.cx_px,
            .cy_px = lens.cy_px,
            .k1 = lens.k1,
            .k2 = lens.k2,
            .k3 = lens.k3,
            .p1 = lens.p1,
            .p2 = lens.p2};
}

double foldR2(const RationalLens& lens) {
    return std::min(firstCrossing(radialGrowth(lens), kLastR2),
                    firstCrossing({1.0, lens.k4, lens.k5, lens.k6}, kLastR2));
}

std::optional<Eigen::Vector2d> distorted(const RationalLens& lens, double fold_r2,
                                         const Eigen::Vector2d& xy) {
    if (!unfolded(lens, fold_r2, xy)) {
        return std::nullopt;
    }
    return bent(lens, xy);
}

std::optional<Eigen::Vector2d> undistorted(const RationalLens& lens, double fold_r2,
                                           const Eigen::Vector2d& distorted_xy) {
    const double wanted = distorted_xy.norm();
    if (!std::isfinite(wanted)) {
        return std::nullopt;
    }
    if (wanted == 0) {
        return Eigen::Vector2d::Zero();
    }
    const double tolerance = 1e-9 / lens.f_px * std::max(1.0, wanted);
    Eigen::Vector2d xy = distorted_xy * (radialStart(lens, fold_r2, wanted) / wanted);
    for (int i = 0; i < 30; ++i) {
        const Eigen::Vector2d miss = bent(lens, xy) - distorted_xy;
        if (miss.norm() <= tolerance) {
            return unfolded(lens, fold_r2, xy) ? std::optional(xy) : std::nullopt;
        }
        xy -= jacobian(lens, xy).inverse() * miss;
        if (!xy.allFinite()) {
            break;
        }
    }
    return std::nullopt;
}

}  // namespace pmts::camera::rational
