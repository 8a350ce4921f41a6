#include "pmts/calibration/distortion_table.hpp"

#include <Eigen/Geometry>
#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <map>

namespace pmts::calibration {
namespace {

using camera::RadialTableLens;
using core::ErrorKind;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Row = RadialTableLens::Row;

constexpr std::size_t kLeastSpots = 3;
constexpr double kNearCentre_px = 60.0;  ///< a spot this near tells where the axis is
constexpr double kAtCentre_px = 4.0;     ///< nearer ones are the centre itself, not a row
constexpr double kTellsWidth_px = 100.0;
constexpr double kTellsTwist_px = 50.0;
constexpr int kRounds = 4;
constexpr std::size_t kRowsForWidth = 4;

QString text(const char* sentence) { return QCoreApplication::translate("DistortionTable", sentence); }

double angleBetween(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// A spot with the direction to the target in the camera's frame at its pointing, as far as the rig's rotations are right.
struct Seen {
    Vector2d from_centre_px;
    Vector3d direction;
};

std::vector<Seen> seenSpots(const TableRun& run, const camera::Rig& rig) {
    const Vector3d target = geometry::stationFromPolar(run.target);
    std::vector<Seen> seen;
    for (const TableSpot& spot : run.spots) {
        const camera::CameraPose pose = camera::cameraPose(rig.mount, spot.at);
        seen.push_back({spot.px - rig.lens.principalPoint(),
                        (pose.station_from_camera.transpose() * (target - pose.centre_station_m)).normalized()});
    }
    return seen;
}

/// Two directions square to the axis, near the camera's x and y.
struct Across {
    explicit Across(const Vector3d& axis) : x((Vector3d::UnitX() - axis * axis.x()).normalized()), y(axis.cross(x)) {}
    [[nodiscard]] Vector2d of(const Vector3d& direction) const { return {direction.dot(x), direction.dot(y)}; }
    Vector3d x, y;
};

/// The direction of the principal point, by the spot nearest to it, the pixel width and the turn of the picture.
class Axis {
public:
    Axis(const std::vector<Seen>& seen, double first_width_rad) : seen_(seen), width_rad_(first_width_rad) {
        nearest_ = &*std::min_element(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
            return a.from_centre_px.norm() < b.from_centre_px.norm();
        });
        direction_ = nearest_->direction;
        for (int round = 0; round < kRounds; ++round) {
            turn_ = meanTurn();
            width_rad_ = meanWidth();
            const Across across(nearest_->direction);
            const Vector2d back = Eigen::Rotation2Dd(turn_) * Vector2d(-width_rad_ * nearest_->from_centre_px);
            direction_ = (nearest_->direction + across.x * back.x() + across.y * back.y()).normalized();
        }
    }
    [[nodiscard]] const Vector3d& direction() const { return direction_; }
    [[nodiscard]] double nearest_px() const { return nearest_->from_centre_px.norm(); }

private:
    /// From the picture's directions to the model's: the twist that the rig does not know.
    [[nodiscard]] double meanTurn() const {
        const Across across(direction_);
        Vector2d sum = Vector2d::Zero();
        for (const Seen& spot : seen_) {
            if (spot.from_centre_px.norm() > kTellsTwist_px) {
                const Vector2d there = across.of(spot.direction);
                const double turn = std::atan2(there.y(), there.x()) - std::atan2(spot.from_centre_px.y(), spot.from_centre_px.x());
                sum += spot.from_centre_px.norm() * Vector2d(std::cos(turn), std::sin(turn));
            }
        }
        return sum.isZero(0) ? 0.0 : std::atan2(sum.y(), sum.x());
    }
    [[nodiscard]] double meanWidth() const {
        double angles = 0, pixels = 0;
        for (const Seen& spot : seen_) {
            const double radius_px = spot.from_centre_px.norm();
            if (radius_px > kAtCentre_px && radius_px < kTellsWidth_px) {
                angles += angleBetween(spot.direction, direction_);
                pixels += radius_px;
            }
        }
        return pixels > 0 ? angles / pixels : width_rad_;
    }

    const std::vector<Seen>& seen_;
    const Seen* nearest_ = nullptr;
    Vector3d direction_;
    double turn_ = 0.0;
    double width_rad_;
};

RadiusDirection nearestDirection(const Vector2d& from_centre_px) {
    auto best = RadiusDirection::kRight;
    for (int i = 1; i < kRadiusDirections; ++i) {
        const auto candidate = static_cast<RadiusDirection>(i);
        if (directionInPicture(candidate).dot(from_centre_px) > directionInPicture(best).dot(from_centre_px)) {
            best = candidate;
        }
    }
    return best;
}

std::optional<RadialTableLens> asLens(const std::vector<Row>& rows) {
    return whyNoTable(rows).isEmpty() ? std::optional(RadialTableLens{.cx_px = 0, .cy_px = 0, .rows = rows}) : std::nullopt;
}

}  // namespace

Vector2d directionInPicture(RadiusDirection direction) {
    static const double kHalf = std::sqrt(0.5);
    switch (direction) {
        case RadiusDirection::kRight: return {1, 0};
        case RadiusDirection::kLeft: return {-1, 0};
        case RadiusDirection::kUp: return {0, -1};
        case RadiusDirection::kDown: return {0, 1};
        case RadiusDirection::kUpRight: return {kHalf, -kHalf};
        case RadiusDirection::kUpLeft: return {-kHalf, -kHalf};
        case RadiusDirection::kDownRight: return {kHalf, kHalf};
        case RadiusDirection::kDownLeft: break;
    }
    return {-kHalf, kHalf};
}

QString directionName(RadiusDirection direction) {
    switch (direction) {
        case RadiusDirection::kRight: return text("right");
        case RadiusDirection::kLeft: return text("left");
        case RadiusDirection::kUp: return text("up");
        case RadiusDirection::kDown: return text("down");
        case RadiusDirection::kUpRight: return text("up and right");
        case RadiusDirection::kUpLeft: return text("up and left");
        case RadiusDirection::kDownRight: return text("down and right");
        case RadiusDirection::kDownLeft: break;
    }
    return text("down and left");
}

std::vector<PlannedSpot> plannedSpots(const camera::Rig& rig, const std::vector<RadiusDirection>& directions, double step_px,
                                      double margin_px) {
    const Vector2d centre = rig.lens.principalPoint();
    std::vector<PlannedSpot> spots;
    if (directions.empty() || !(step_px >= 1.0)) {
        return spots;
    }
    spots.push_back({centre, directions.front()});
    const auto is_inside = [&](const Vector2d& px) {
        return px.x() >= margin_px && px.y() >= margin_px && px.x() <= rig.width_px - 1 - margin_px &&
               px.y() <= rig.height_px - 1 - margin_px;
    };
    for (const RadiusDirection direction : directions) {
        for (int step = 1;; ++step) {
            const Vector2d px = centre + step * step_px * directionInPicture(direction);
            if (!is_inside(px) || !rig.lens.cameraFromPixel(px)) {
                break;
            }
            spots.push_back({px, direction});
        }
    }
    return spots;
}

core::Result<std::vector<TableCurve>> curvesOfRun(const TableRun& run, const camera::Rig& rig) {
    if (run.spots.size() < kLeastSpots || !(run.target.slope_distance_m > 0)) {
        return core::fail(ErrorKind::kBadInput, text("There are too few places of the target for a table."),
                          text("Bring it to the centre and to two places more."));
    }
    const std::vector<Seen> seen = seenSpots(run, rig);
    const Axis axis(seen, 1.0 / rig.lens.focalLengthPx());
    if (axis.nearest_px() > kNearCentre_px) {
        return core::fail(ErrorKind::kBadInput, text("The target was never near the centre of the picture."),
                          text("Bring it to the cross of the grid first."));
    }
    std::map<RadiusDirection, TableCurve> curves;
    for (const Seen& spot : seen) {
        const double radius_px = spot.from_centre_px.norm();
        if (radius_px < kAtCentre_px) {
            continue;
        }
        const RadiusDirection direction = nearestDirection(spot.from_centre_px);
        TableCurve& curve = curves[direction];
        curve.distance_m = run.target.slope_distance_m;
        curve.direction = direction;
        curve.rows.push_back({radius_px, angleBetween(spot.direction, axis.direction())});
    }
    std::vector<TableCurve> result;
    for (auto& [direction, curve] : curves) {
        curve.rows.push_back({0.0, 0.0});
        std::sort(curve.rows.begin(), curve.rows.end(), [](const Row& a, const Row& b) { return a.radius_px < b.radius_px; });
        result.push_back(std::move(curve));
    }
    return result;
}

core::Result<DistortionTable> tableOfCurves(const std::vector<TableCurve>& curves, const Vector2d& centre_px, double step_px) {
    std::vector<RadialTableLens> lenses;
    double reach_px = 0;
    for (const TableCurve& curve : curves) {
        if (const auto lens = asLens(curve.rows); lens && curve.rows.size() > 2) {
            lenses.push_back(*lens);
            reach_px = std::max(reach_px, curve.rows.back().radius_px);
        }
    }
    if (lenses.empty() || reach_px < 2 * step_px) {
        return core::fail(ErrorKind::kBadInput, text("No radius has been measured far enough for a table."),
                          text("Measure at least two steps along one direction."));
    }
    DistortionTable table;
    table.lens = {.cx_px = centre_px.x(), .cy_px = centre_px.y(), .rows = {{0.0, 0.0}}};
    table.spread_rad = {0.0};
    const auto add = [&](double radius_px) {
        double sum = 0, least = 1e9, most = 0;
        int count = 0;
        for (const RadialTableLens& lens : lenses) {
            if (const auto angle = angleAt_rad(lens, radius_px)) {
                sum += *angle, ++count, least = std::min(least, *angle), most = std::max(most, *angle);
            }
        }
        if (count > 0) {
            table.lens.rows.push_back({radius_px, sum / count});
            table.spread_rad.push_back(most - least);
        }
    };
    for (double radius_px = step_px; radius_px < reach_px - 0.3 * step_px; radius_px += step_px) {
        add(radius_px);
    }
    add(reach_px);
    if (const QString why = whyNoTable(table.lens.rows); !why.isEmpty()) {
        return core::fail(ErrorKind::kBadInput, why, text("Measure that radius again."));
    }
    return table;
}

double centralPixelWidth_rad(const std::vector<Row>& rows) {
    if (rows.size() < 2) {
        return 0.0;
    }
    // angle = width r + bend r^3 over the first rows: one row alone carries its whole error into the ideal lens.
    const std::size_t last = std::min(rows.size() - 1, kRowsForWidth);
    const double reach_px = rows[last].radius_px;
    double aa = 0, ab = 0, bb = 0, ay = 0, by = 0;
    for (std::size_t i = 1; i <= last; ++i) {
        const double a = rows[i].radius_px / reach_px;
        const double b = a * a * a;
        aa += a * a, ab += a * b, bb += b * b, ay += a * rows[i].angle_rad, by += b * rows[i].angle_rad;
    }
    const double determinant = aa * bb - ab * ab;
    return last < 3 || determinant < 1e-9 ? rows[1].angle_rad / rows[1].radius_px : (ay * bb - by * ab) / determinant / reach_px;
}

double idealLensAngle_rad(double central_pixel_rad, double radius_px) { return std::atan(central_pixel_rad * radius_px); }

double idealLineAngle_rad(double central_pixel_rad, double radius_px) { return central_pixel_rad * radius_px; }

std::vector<PixelWidth> pixelWidths(const std::vector<Row>& rows) {
    std::vector<PixelWidth> widths;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double wide_px = rows[i].radius_px - rows[i - 1].radius_px;
        if (wide_px > 0) {
            widths.push_back({(rows[i].radius_px + rows[i - 1].radius_px) / 2, (rows[i].angle_rad - rows[i - 1].angle_rad) / wide_px});
        }
    }
    return widths;
}

std::optional<double> angleAt_rad(const RadialTableLens& table, double radius_px) {
    const auto ray = camera::Lens(table).cameraFromPixel({table.cx_px + radius_px, table.cy_px});
    return ray ? std::optional(std::atan2(ray->x(), ray->z())) : std::nullopt;
}

}  // namespace pmts::calibration
