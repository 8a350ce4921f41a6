#include "pmts/targeting/bring_pixel.hpp"

#include <QCoreApplication>

#include <Eigen/Dense>

#include <cmath>

namespace pmts::targeting {
namespace {

constexpr int kMostRounds = 20;
constexpr double kEnough_px = 1e-3;
constexpr double kStep_rad = 1e-6;
constexpr double kLeastTilt_px_per_rad = 1.0;  ///< less, and the circle does not move the picture
constexpr double kLongestTurn_rad = 0.5;       ///< of one round: the next one starts from a true picture again

core::Error unreachable() {
    return {.kind = core::ErrorKind::kUndefined,
            .happened = QCoreApplication::translate("Targeting", "No turn brings this spot there."),
            .remedy = QCoreApplication::translate("Targeting",
                                                  "Drag it to the reticle, or click it and press Move."),
            .info_code = std::nullopt,
            .detail = {}};
}

geometry::Pointing turned(const geometry::Pointing& from, double ha_rad, double va_rad) {
    return {from.ha + core::Angle::fromRad(ha_rad), from.va + core::Angle::fromRad(va_rad)};
}

/// Columns: how the pixel of the spot moves with HA and with VA, px per rad.
core::Result<Eigen::Matrix2d> slope(const PixelToPointing& model, const Eigen::Vector3d& p_station,
                                    const geometry::Pointing& at) {
    Eigen::Matrix2d per_rad;
    for (int circle = 0; circle < 2; ++circle) {
        const double ha_rad = circle == 0 ? kStep_rad : 0.0;
        const double va_rad = circle == 0 ? 0.0 : kStep_rad;
        const auto ahead = model.pixelForPoint(p_station, turned(at, ha_rad, va_rad));
        PMTS_TRY(ahead);
        const auto behind = model.pixelForPoint(p_station, turned(at, -ha_rad, -va_rad));
        PMTS_TRY(behind);
        per_rad.col(circle) = (*ahead - *behind) / (2 * kStep_rad);
    }
    return per_rad;
}

}  // namespace

core::Result<geometry::Pointing> pointingToBring(const PixelToPointing& model, const Eigen::Vector2d& grabbed_px,
                                                 const Eigen::Vector2d& released_px, const geometry::Pointing& at,
                                                 double slope_distance_m) {
    const auto ray = model.rayForPixel(grabbed_px, at);
    PMTS_TRY(ray);
    const auto p_station = geometry::intersectSphere(*ray, slope_distance_m);
    PMTS_TRY(p_station);
    geometry::Pointing now = at;
    for (int round = 0; round < kMostRounds; ++round) {
        const auto px = model.pixelForPoint(*p_station, now);
        PMTS_TRY(px);
        const Eigen::Vector2d left_px = released_px - *px;
        if (left_px.norm() < kEnough_px) {
            return geometry::Pointing{core::normalized(now.ha), now.va};
        }
        const auto per_rad = slope(model, *p_station, now);
        PMTS_TRY(per_rad);
        const auto split = per_rad->jacobiSvd(Eigen::ComputeFullU | Eigen::ComputeFullV);
        if (split.singularValues()(1) < kLeastTilt_px_per_rad) {
            return tl::unexpected(unreachable());  // on the handle the picture does not tilt with VA
        }
        Eigen::Vector2d turn_rad = split.solve(left_px);
        turn_rad *= std::min(1.0, kLongestTurn_rad / std::max(turn_rad.norm(), 1e-12));
        now = turned(now, turn_rad.x(), turn_rad.y());
    }
    return tl::unexpected(unreachable());
}

}  // namespace pmts::targeting
