#pragma once

#include "pmts/camera/rig.hpp"
#include "pmts/core/result.hpp"
#include "pmts/geometry/polar.hpp"

#include <Eigen/Core>
#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace pmts::calibration {

/// Where along the picture a target is led from the principal point.
enum class RadiusDirection { kRight, kLeft, kUp, kDown, kUpRight, kUpLeft, kDownRight, kDownLeft };
inline constexpr int kRadiusDirections = 8;

/// Unit vector in the picture (u right, v down).
[[nodiscard]] Eigen::Vector2d directionInPicture(RadiusDirection direction);
/// `right`, `up and left`, for people.
[[nodiscard]] QString directionName(RadiusDirection direction);

/// The places a target shall come to: the principal point first, then every `step_px` along each direction, as long
/// as they are `margin_px` inside the picture.
struct PlannedSpot {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    RadiusDirection direction = RadiusDirection::kRight;
};
[[nodiscard]] std::vector<PlannedSpot> plannedSpots(const camera::Rig& rig, const std::vector<RadiusDirection>& directions,
                                                    double step_px, double margin_px);

/// The target seen in one frame.
struct TableSpot {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    geometry::Pointing at{};  ///< circle readings of the frame
};

/// One fixed target seen from many pointings.
struct TableRun {
    geometry::PolarPoint target;  ///< circle readings with the telescope on it, and its slope distance
    std::vector<TableSpot> spots;
};

/// True angle off the axis against the radius, one direction at one distance.
struct TableCurve {
    double distance_m = 0.0;
    RadiusDirection direction = RadiusDirection::kRight;
    std::vector<camera::RadialTableLens::Row> rows;  ///< rising, the first is (0, 0)
};

/// Turns the readings of a run into angles off the axis, exactly: the direction to the target is taken from the camera's
/// own centre (offset of `rig.mount`, the target's range), rotated into the camera's frame at each pointing, and the
/// angle is the one between two such directions on the sphere. So neither the tilt of the telescope nor the parallax of a
/// near target is in it, and the camera's small rotations need not be known: the axis is the direction of the spot
/// nearest to the principal point, led over its last pixels by the pixel width found. A spot counts for
/// the direction nearest to it. kBadInput with fewer than 3 spots or none within 60 px of the principal point.
[[nodiscard]] core::Result<std::vector<TableCurve>> curvesOfRun(const TableRun& run, const camera::Rig& rig);

/// The curves' mean at every step, as a lens about the rig's principal point, and how far they are apart.
struct DistortionTable {
    camera::RadialTableLens lens;
    std::vector<double> spread_rad;  ///< of each row: largest less smallest of the curves
};
/// kBadInput with no curve of at least two steps, or where the mean does not rise (whyNoTable()).
[[nodiscard]] core::Result<DistortionTable> tableOfCurves(const std::vector<TableCurve>& curves, const Eigen::Vector2d& centre_px,
                                                          double step_px);

/// Angle between neighbouring pixels at the centre of a table or curve, by an odd cubic through its first four rows.
[[nodiscard]] double centralPixelWidth_rad(const std::vector<camera::RadialTableLens::Row>& rows);
/// atan(r / f) with f the inverse of the central pixel width: what a lens without distortion would show.
[[nodiscard]] double idealLensAngle_rad(double central_pixel_rad, double radius_px);
/// Central pixel width times r: the straight line of the thesis's fig. 5.14.
[[nodiscard]] double idealLineAngle_rad(double central_pixel_rad, double radius_px);
/// Angle of one pixel between two rows, at their middle (fig. 5.15).
struct PixelWidth {
    double radius_px = 0.0;
    double width_rad = 0.0;
};
[[nodiscard]] std::vector<PixelWidth> pixelWidths(const std::vector<camera::RadialTableLens::Row>& rows);
/// Angle at a radius by the table's own interpolation; absent past its last row.
[[nodiscard]] std::optional<double> angleAt_rad(const camera::RadialTableLens& table, double radius_px);

/// Why these rows make no table, one sentence naming the row; empty when they do.
[[nodiscard]] QString whyNoTable(const std::vector<camera::RadialTableLens::Row>& rows);

/// `radius_px,angle_gon,deviation_gon` with a comment for the centre; read back to rounding. The deviation is from the ideal
/// lens and is not read.
[[nodiscard]] QByteArray tableToCsv(const camera::RadialTableLens& table);
/// kBadInput names the line.
[[nodiscard]] core::Result<camera::RadialTableLens> tableFromCsv(const QByteArray& csv);

}  // namespace pmts::calibration
