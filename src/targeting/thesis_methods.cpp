#include "pmts/targeting/thesis_methods.hpp"

#include <QCoreApplication>

#include <cmath>

namespace pmts::targeting {
namespace {

using core::Angle;
using geometry::Pointing;

/// What a method adds to the readings of the photo.
struct AddedAngles {
    Angle h;
    Angle v;
};

Pointing added(const Pointing& photo, const AddedAngles& angles) {
    return {.ha = core::normalized(photo.ha + angles.h), .va = photo.va + angles.v};
}

AddedAngles tangentAngles(const ThesisCamera& camera, const Eigen::Vector2d& px) {
    const Eigen::Vector2d from_centre = (px - camera.centre_px) / camera.f_px;
    return {Angle::fromRad(std::atan(from_centre.x())), Angle::fromRad(std::atan(from_centre.y()))};
}

core::Result<Pointing> withOffset(const ThesisCamera& camera, const Pointing& photo, const AddedAngles& seen,
                                  double slope_distance_m) {
    const double lever_m = std::hypot(camera.forward_m, camera.up_m);
    if (!(slope_distance_m > lever_m)) {
        return core::fail(core::ErrorKind::kUndefined,
                          QCoreApplication::translate("Targeting", "The target would be inside the camera."),
                          QCoreApplication::translate("Targeting", "Enter a longer distance."));
    }
    const Angle parallax_h =
        Angle::fromRad(std::asin(camera.forward_m * core::sin(seen.h) / slope_distance_m));
    const Angle parallax_v = Angle::fromRad(std::asin(lever_m * core::sin(seen.v) / slope_distance_m));
    return added(photo, {seen.h + parallax_h, seen.v + parallax_v});
}

core::Result<Angle> perPixel(Angle between, double pixels) {
    if (pixels == 0) {
        return core::fail(
            core::ErrorKind::kUndefined,
            QCoreApplication::translate("Targeting", "The two objects are in one column or row."),
            QCoreApplication::translate("Targeting", "Choose objects at opposite edges of the photo."));
    }
    return between / pixels;
}

}  // namespace

core::Result<Angle> pixelAngleAcross(const SightedPixel& left, const SightedPixel& right) {
    return perPixel(core::normalizedSigned(right.pointing.ha - left.pointing.ha), right.px.x() - left.px.x());
}

core::Result<Angle> pixelAngleDown(const SightedPixel& upper, const SightedPixel& lower) {
    return perPixel(core::normalizedSigned(lower.pointing.va - upper.pointing.va), lower.px.y() - upper.px.y());
}

core::Result<AveragePixelAngle> averagePixelAngle(const SightedPixel& left, const SightedPixel& right,
                                                  const SightedPixel& upper, const SightedPixel& lower) {
    const auto across = pixelAngleAcross(left, right);
    PMTS_TRY(across);
    const auto down = pixelAngleDown(upper, lower);
    PMTS_TRY(down);
    return AveragePixelAngle{.horizontal = *across, .vertical = *down};
}

Pointing apa(const ThesisCamera& camera, const Pointing& photo, const Eigen::Vector2d& px) {
    const Eigen::Vector2d from_centre_px = px - camera.centre_px;
    return added(photo, {camera.pixel_angle.horizontal * from_centre_px.x(),
                         camera.pixel_angle.vertical * from_centre_px.y()});
}

Pointing tpa(const ThesisCamera& camera, const Pointing& photo, const Eigen::Vector2d& px) {
    return added(photo, tangentAngles(camera, px));
}

core::Result<Pointing> oatpa(const ThesisCamera& camera, const Pointing& photo, const Eigen::Vector2d& px,
                             double slope_distance_m) {
    return withOffset(camera, photo, tangentAngles(camera, px), slope_distance_m);
}

core::Result<Pointing> rectifiedOatpa(const ThesisCamera& camera, const camera::RadialTableLens& table,
                                      const Pointing& photo, const Eigen::Vector2d& px,
                                      double slope_distance_m) {
    const auto ray = camera::Lens(table).cameraFromPixel(px);
    PMTS_TRY(ray);
    const AddedAngles seen{Angle::fromRad(std::atan2(ray->x(), ray->z())),
                           Angle::fromRad(std::atan2(ray->y(), ray->z()))};
    return withOffset(camera, photo, seen, slope_distance_m);
}

std::optional<camera::RadialTableLens> tableFromLens(const camera::Lens& lens, const Eigen::Vector2d& centre_px,
                                                     double reach_px) {
    constexpr double kStep_px = 30;
    camera::RadialTableLens table{.cx_px = centre_px.x(), .cy_px = centre_px.y(), .rows = {{0.0, 0.0}}};
    for (double radius_px = kStep_px; radius_px <= reach_px; radius_px += kStep_px) {
        const auto ray = lens.cameraFromPixel(lens.principalPoint() + Eigen::Vector2d(radius_px, 0));
        if (!ray) {
            break;
        }
        table.rows.push_back({radius_px, std::atan2(ray->x(), ray->z())});
    }
    return table.rows.size() > 2 ? std::optional(table) : std::nullopt;
}

}  // namespace pmts::targeting
