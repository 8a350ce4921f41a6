#pragma once

#include "pmts/camera/lens.hpp"
#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"

#include <Eigen/Core>

#include <optional>

namespace pmts::targeting {

/// The thesis's four ways from a pixel to a pointing (its chapter 6), kept for comparison with its tables.
/// All add angles to the readings of the photo's centre; only the rigorous model (PixelToPointing) rotates
/// the ray. Adding is wrong by itself away from the horizon and away from the centre: more than 0.5 gon in
/// a corner at a tilt of 6 gon.

/// Angle of one pixel, the mean over the photo.
struct AveragePixelAngle {
    core::Angle horizontal;
    core::Angle vertical;
};

/// What the methods know of the camera. The defaults made the thesis's tables 6.1-6.3 (640x480, PMTS
/// reference, 8).
struct ThesisCamera {
    Eigen::Vector2d centre_px{315, 240};
    AveragePixelAngle pixel_angle{core::Angle::fromGon(0.07849), core::Angle::fromGon(0.07849)};
    double f_px = 784;
    double forward_m = 0.085;  ///< Yo
    double up_m = 0.052;       ///< Zo
};

/// A target in the photo and the readings of the telescope when it was on it.
struct SightedPixel {
    Eigen::Vector2d px;
    geometry::Pointing pointing;
};

/// Eq. 6.1: angle of a pixel across, from the objects at the left and the right edge. kUndefined when both are
/// in one column.
[[nodiscard]] core::Result<core::Angle> pixelAngleAcross(const SightedPixel& left, const SightedPixel& right);

/// Eq. 6.2: angle of a pixel down, from the objects at the upper and the lower edge. kUndefined likewise.
[[nodiscard]] core::Result<core::Angle> pixelAngleDown(const SightedPixel& upper, const SightedPixel& lower);

/// Eq. 6.1-6.2: the angle between the extreme objects divided by the pixels between them, for HA between the
/// left and the right one, for VA between the upper and the lower one. kUndefined when a pair shares its
/// column or row.
[[nodiscard]] core::Result<AveragePixelAngle> averagePixelAngle(const SightedPixel& left,
                                                                const SightedPixel& right,
                                                                const SightedPixel& upper,
                                                                const SightedPixel& lower);

/// APA, average pixel angle: pixels from the centre times the angle of a pixel. The printed table is met
/// within 0.001 gon by 0.07849 gon for both directions about column 316; about column 315, as the other
/// methods have it, no one angle fits its HA column (0.07824 to 0.0814). Known error: up to 1.47 gon on the
/// thesis's 11 points; a pixel is 20 % wider at the centre than at the edge.
[[nodiscard]] geometry::Pointing apa(const ThesisCamera& camera, const geometry::Pointing& photo,
                                     const Eigen::Vector2d& px);

/// TPA, tangent pixel angle: atan(pixels / f).
/// Known error: up to 1.76 gon there; neither lens distortion nor the camera's offset is in it. The printed
/// table is met within 0.010 gon (its 22/7 for pi).
[[nodiscard]] geometry::Pointing tpa(const ThesisCamera& camera, const geometry::Pointing& photo,
                                     const Eigen::Vector2d& px);

/// OATPA, offset added TPA: TPA plus asin(Yo sin h / SD) and asin(sqrt(Yo^2 + Zo^2) sin v / SD), with h and v
/// the angles TPA adds. The thesis's text subtracts; its table is met (0.010 gon) only by adding. Known
/// error: up to 1.71 gon there. kUndefined when the slope distance is shorter than the offset.
[[nodiscard]] core::Result<geometry::Pointing> oatpa(const ThesisCamera& camera,
                                                     const geometry::Pointing& photo,
                                                     const Eigen::Vector2d& px, double slope_distance_m);

/// OATPA with h and v taken from the distortion table instead of f: the table's ray, seen from above and from
/// the side. Known error: up to 0.06 gon as printed in the thesis's table 6.4, whose distortion table is not
/// printed; with a table made from the lens fitted to the same points it is up to 0.56 gon, because that
/// lens's own centre is not the photo's. kUndefined past the table's last row too.
[[nodiscard]] core::Result<geometry::Pointing> rectifiedOatpa(const ThesisCamera& camera,
                                                              const camera::RadialTableLens& table,
                                                              const geometry::Pointing& photo,
                                                              const Eigen::Vector2d& px,
                                                              double slope_distance_m);

/// A lens as somebody would have measured its distortion table: every 30 px along a row to the right, laid
/// about this centre. Absent when the lens sees less than two steps.
[[nodiscard]] std::optional<camera::RadialTableLens> tableFromLens(const camera::Lens& lens,
                                                                   const Eigen::Vector2d& centre_px,
                                                                   double reach_px);

}  // namespace pmts::targeting
