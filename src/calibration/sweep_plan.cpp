#include "pmts/calibration/sweep_plan.hpp"

#include "pmts/geometry/frames.hpp"
#include "pmts/geometry/polar.hpp"

#include <Eigen/LU>
#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmts::calibration {
namespace {

using camera::MountKind;
using core::Angle;
using geometry::Pointing;

using Place = std::pair<Pointing, Eigen::Vector2d>;

/// Circle readings near `start` at which the rig shows the spot at this pixel: Newton's method on both
/// circles, or on HA alone when the camera does not tilt.
std::optional<Place> pointingShowing(const camera::Rig& rig, const Eigen::Vector3d& p_station,
                                     const Eigen::Vector2d& wanted_px, Pointing at) {
    constexpr double kStep_rad = 1e-5;
    const auto moved = [](const Pointing& from, double ha_rad, double va_rad) {
        return Pointing{from.ha + Angle::fromRad(ha_rad), from.va + Angle::fromRad(va_rad)};
    };
    const bool tilts = rig.mount.kind == MountKind::kTelescope;
    for (int i = 0; i < 30; ++i) {
        const auto px = camera::pixelFromStation(rig, at, p_station);
        const auto by_ha = camera::pixelFromStation(rig, moved(at, kStep_rad, 0), p_station);
        const auto by_va = camera::pixelFromStation(rig, moved(at, 0, kStep_rad), p_station);
        if (!px || !by_ha || !by_va) {
            return std::nullopt;
        }
        const Eigen::Vector2d miss = wanted_px - *px;
        Eigen::Matrix2d slope;
        slope << (*by_ha - *px) / kStep_rad, (*by_va - *px) / kStep_rad;
        Eigen::Vector2d step_rad(miss.x() / slope(0, 0), 0);
        if (tilts) {
            step_rad = slope.inverse() * miss;
        }
        if (!step_rad.allFinite()) {
            return std::nullopt;
        }
        if (step_rad.norm() < 1e-7) {
            return Place{{core::normalized(at.ha), at.va}, *px};
        }
        step_rad *= std::min(1.0, 0.2 / step_rad.norm());
        at = moved(at, step_rad.x(), step_rad.y());
    }
    return std::nullopt;
}

double along(double from, double to, double share) { return from + share * (to - from); }

double spacedOut(double share, double towards_edges) {
    return along(share, 0.5 - 0.5 * std::cos(std::numbers::pi * share), towards_edges);
}

/// Pixels of a grid, there and back row by row; `shifted` moves the columns on by half a step.
std::vector<Eigen::Vector2d> gridOf(const camera::Rig& rig, int columns, int rows,
                                    const SweepPlanOptions& options, bool shifted) {
    std::vector<Eigen::Vector2d> grid;
    const double first_u = std::max(options.margin_px, 0.5 * (1 - options.reach) * (rig.width_px - 1));
    const double first_v = std::max(options.margin_px, 0.5 * (1 - options.reach) * (rig.height_px - 1));
    const double last_u = rig.width_px - 1 - first_u;
    const double last_v = rig.height_px - 1 - first_v;
    for (int row = 0; row < rows; ++row) {
        const double v = rows > 1
                             ? along(first_v, last_v, spacedOut(row / (rows - 1.0), options.towards_edges))
                             : 0.5 * (rig.height_px - 1);
        for (int i = 0; i < columns; ++i) {
            const int column = row % 2 == 0 ? i : columns - 1 - i;
            const double share = shifted ? (column + 0.5) / columns : column / (columns - 1.0);
            grid.emplace_back(along(first_u, last_u, spacedOut(share, options.towards_edges)), v);
        }
    }
    return grid;
}

struct Shape {
    int columns = 2;
    int rows = 1;
};

/// As square as the picture allows, both faces within the number allowed.
Shape shapeOf(const camera::Rig& rig, const SweepPlanOptions& options, bool both) {
    Shape best{.columns = 2, .rows = 2};
    double best_score = 0;
    const double wide = static_cast<double>(rig.width_px) / rig.height_px;
    for (int rows = 2; rows <= options.most_pointings; ++rows) {
        for (int columns = 2; columns <= options.most_pointings; ++columns) {
            const int count = columns * rows * (both ? 2 : 1);
            if (count > options.most_pointings) {
                break;
            }
            const double stretch = wide * (rows - 1.0) / (columns - 1.0);
            const double score = count - 20 * std::abs(std::log(stretch));
            if (score > best_score) {
                best_score = score;
                best = {columns, rows};
            }
        }
    }
    return best;
}

double way_gon(const Pointing& from, const Pointing& to) {
    return std::max(std::abs(core::normalizedSigned(to.ha - from.ha).gon()),
                    std::abs((to.va - from.va).gon()));
}

}  // namespace

core::Duration turningTime(double way_gon, double speed_gon_s, double acceleration_gon_s2) {
    const double ramps_gon = speed_gon_s * speed_gon_s / acceleration_gon_s2;
    const double time_s = way_gon < ramps_gon ? 2 * std::sqrt(way_gon / acceleration_gon_s2)
                                              : way_gon / speed_gon_s + speed_gon_s / acceleration_gon_s2;
    return std::chrono::duration_cast<core::Duration>(std::chrono::duration<double>(time_s));
}

SweepPlanOptions scouting(int stage) {
    if (stage == 2) {  // both faces have been seen: the lens is the same in either
        return {.most_pointings = 6, .towards_edges = 0.0, .reach = 0.85, .centre_out = true, .both_faces = false};
    }
    return {.most_pointings = 8, .towards_edges = 0.0, .reach = stage == 0 ? 0.25 : 0.6, .centre_out = true};
}

core::Result<SweepPlan> planSweep(const camera::Rig& about, const Eigen::Vector3d& p_station,
                                  const SweepPlanOptions& options) {
    const auto direction = geometry::pointingFromDirection(p_station);
    PMTS_TRY(direction);
    const bool tilts = about.mount.kind == MountKind::kTelescope;
    const bool both = tilts && options.both_faces;
    const Shape shape =
        tilts ? shapeOf(about, options, both) : Shape{.columns = options.most_pointings, .rows = 1};
    SweepPlan plan;
    const auto take = [&](std::vector<Eigen::Vector2d> pixels, Pointing near) {
        if (options.centre_out) {
            const Eigen::Vector2d middle(0.5 * about.width_px, 0.5 * about.height_px);
            if (options.reach < 0.5) {
                pixels.insert(pixels.begin(), middle);
            }
            std::stable_sort(pixels.begin(), pixels.end(),
                             [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                                 return (a - middle).squaredNorm() < (b - middle).squaredNorm();
                             });
        } else if (!plan.pointings.empty()) {  // begins at the end that is nearer
            std::reverse(pixels.begin(), pixels.end());
        }
        for (const Eigen::Vector2d& px : pixels) {
            if (const auto place = pointingShowing(about, p_station, px, near)) {
                plan.pointings.push_back(place->first);
                plan.wanted_px.push_back(place->second);
                near = place->first;
            }
        }
    };
    take(gridOf(about, shape.columns, shape.rows, options, false), *direction);
    if (both) {
        take(gridOf(about, shape.columns, shape.rows, options, true), geometry::otherFace(*direction));
    }
    if (static_cast<int>(plan.pointings.size()) < (options.most_pointings < 8 ? 4 : 8)) {
        return core::fail(
            core::ErrorKind::kUndefined,
            QCoreApplication::translate("Calibration", "This spot cannot be swept over the picture."),
            QCoreApplication::translate("Calibration", "Choose a spot near the horizon."));
    }
    for (std::size_t i = 0; i < plan.pointings.size(); ++i) {
        const double way = i > 0 ? way_gon(plan.pointings[i - 1], plan.pointings[i]) : 0.0;
        plan.instrument_time += turningTime(way, options.speed_gon_s, options.acceleration_gon_s2) +
                                options.settle + options.look;
    }
    return plan;
}

}  // namespace pmts::calibration
