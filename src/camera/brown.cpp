#include "brown.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace pmts::camera::brown {
namespace {

double radialFactor(const BrownLens& lens, double r2) {
    return 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
}

/// d/dr of r * radialFactor(r2), as a function of s = r2.
double radialGrowth(const BrownLens& lens, double s) {
    return 1 + s * (3 * lens.k1 + s * (5 * lens.k2 + s * 7 * lens.k3));
}

/// Positive s at which radialGrowth() turns, in rising order: between them it is monotone.
std::vector<double> turningPoints(const BrownLens& lens) {
    const double a = 21 * lens.k3;
    const double b = 10 * lens.k2;
    const double c = 3 * lens.k1;
    std::vector<double> turning;
    if (const double discriminant = b * b - 4 * a * c; discriminant >= 0) {
        const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));  // no cancellation
        for (const double s : {q / a, c / q}) {
            if (std::isfinite(s) && s > 0) {
                turning.push_back(s);
            }
        }
    }
    std::sort(turning.begin(), turning.end());
    return turning;
}

double bisectGrowth(const BrownLens& lens, double growing, double folded) {
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (growing + folded);
        if (middle <= growing || middle >= folded) {
            break;
        }
        (radialGrowth(lens, middle) > 0 ? growing : folded) = middle;
    }
    return growing;
}

Eigen::Vector2d bent(const BrownLens& lens, const Eigen::Vector2d& xy) {
    const double x = xy.x();
    const double y = xy.y();
    const double r2 = xy.squaredNorm();
    return radialFactor(lens, r2) * xy + Eigen::Vector2d(2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x),
                                                         lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y);
}

Eigen::Matrix2d jacobian(const BrownLens& lens, const Eigen::Vector2d& xy) {
    const double x = xy.x();
    const double y = xy.y();
    const double r2 = xy.squaredNorm();
    const double slope = 2 * (lens.k1 + r2 * (2 * lens.k2 + r2 * 3 * lens.k3));  // d factor / d r, over r
    Eigen::Matrix2d j = radialFactor(lens, r2) * Eigen::Matrix2d::Identity() + slope * xy * xy.transpose();
    j(0, 0) += 2 * lens.p1 * y + 6 * lens.p2 * x;
    j(0, 1) += 2 * lens.p1 * x + 2 * lens.p2 * y;
    j(1, 0) += 2 * lens.p1 * x + 2 * lens.p2 * y;
    j(1, 1) += 6 * lens.p1 * y + 2 * lens.p2 * x;
    return j;
}

bool unfolded(const BrownLens& lens, double fold_r2, const Eigen::Vector2d& xy) {
    return xy.allFinite() && xy.squaredNorm() <= fold_r2 && jacobian(lens, xy).determinant() > 0;
}

/// Radius whose radially distorted length is `wanted`, or the fold when it is never that long: a bisection.
double radialStart(const BrownLens& lens, double fold_r2, double wanted) {
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

double foldR2(const BrownLens& lens) {
    double growing = 0;
    std::vector<double> probes = turningPoints(lens);
    const double last = probes.empty() ? 0.0 : probes.back();
    // Past the last turning point the leading term decides; 1e8 is an angle within 0.1 mrad of 100 gon.
    probes.push_back(std::max(2 * last, 1e8));
    for (const double s : probes) {
        if (radialGrowth(lens, s) <= 0) {
            return bisectGrowth(lens, growing, s);
        }
        growing = s;
    }
    return std::numeric_limits<double>::infinity();
}

std::optional<Eigen::Vector2d> distorted(const BrownLens& lens, double fold_r2, const Eigen::Vector2d& xy) {
    if (!unfolded(lens, fold_r2, xy)) {
        return std::nullopt;
    }
    return bent(lens, xy);
}

std::optional<Eigen::Vector2d> undistorted(const BrownLens& lens, double fold_r2,
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

}  // namespace pmts::camera::brown
