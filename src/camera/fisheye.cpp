#include "fisheye.hpp"

#include "radial_roots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmts::camera::fisheye {
namespace {

double bent(const FisheyeLens& lens, double t) {
    const double t2 = t * t;
    return t * (1 + t2 * (lens.k1 + t2 * (lens.k2 + t2 * (lens.k3 + t2 * lens.k4))));
}

double slope(const FisheyeLens& lens, double t) {
    const double t2 = t * t;
    return 1 + t2 * (3 * lens.k1 + t2 * (5 * lens.k2 + t2 * (7 * lens.k3 + t2 * 9 * lens.k4)));
}

}  // namespace

double foldAngle_rad(const FisheyeLens& lens) {
    constexpr double kHalfTurn = std::numbers::pi;
    const double fold_t2 =
        firstCrossing({1.0, 3 * lens.k1, 5 * lens.k2, 7 * lens.k3, 9 * lens.k4}, kHalfTurn * kHalfTurn);
    return std::min(std::sqrt(fold_t2), kHalfTurn);
}

std::optional<double> radiusAtAngle(const FisheyeLens& lens, double fold_rad, double angle_rad) {
    if (!(angle_rad >= 0) || angle_rad > fold_rad) {
        return std::nullopt;
    }
    return bent(lens, angle_rad);
}

std::optional<double> angleAtRadius(const FisheyeLens& lens, double fold_rad, double radius) {
    if (!(radius >= 0) || radius > bent(lens, fold_rad)) {
        return std::nullopt;
    }
    double low = 0;
    double high = fold_rad;
    double angle = std::min(radius, fold_rad);
    for (int i = 0; i < 100 && high - low > 1e-16; ++i) {
        const double miss = bent(lens, angle) - radius;
        (miss < 0 ? low : high) = angle;
        const double newton = angle - miss / slope(lens, angle);
        const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
        if (std::abs(next - angle) < 1e-15) {
            return next;
        }
        angle = next;
    }
    return angle;
}

}  // namespace pmts::camera::fisheye
