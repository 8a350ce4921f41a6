#include "pmts/camera/lens.hpp"

#include "fisheye.hpp"
#include "radial_table.hpp"
#include "rational.hpp"

#include <QCoreApplication>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace pmts::camera {
namespace {

tl::unexpected<core::Error> behindTheCamera() {
    return core::fail(core::ErrorKind::kUndefined,
                      QCoreApplication::translate("Camera", "The point is behind the camera."),
                      QCoreApplication::translate("Camera", "Turn the instrument towards it."));
}

tl::unexpected<core::Error> outsideTheLens() {
    return core::fail(
        core::ErrorKind::kUndefined,
        QCoreApplication::translate("Camera",
                                    "This is outside the part of the picture the lens model describes."),
        QCoreApplication::translate("Camera", "Choose a point nearer to the centre of the picture."));
}

template <class... Parts>
struct Overloaded : Parts... {
    using Parts::operator()...;
};

void requireLens(double f_px, double sum) {
    if (!(f_px > 0) || !std::isfinite(sum)) {
        throw std::logic_error("a lens has a positive focal length and finite parameters");
    }
}

Eigen::Vector2d outwards(const Eigen::Vector2d& across) {
    const double length = across.norm();
    return length > 0 ? Eigen::Vector2d(across / length) : Eigen::Vector2d::Zero();
}

/// A direction at this angle off the axis.
Eigen::Vector3d tilted(const Eigen::Vector2d& from_centre_px, double angle_rad) {
    const Eigen::Vector2d across = std::sin(angle_rad) * outwards(from_centre_px);
    return {across.x(), across.y(), std::cos(angle_rad)};
}

std::optional<Eigen::Vector3d> upright(const std::optional<Eigen::Vector2d>& xy) {
    return xy ? std::optional(Eigen::Vector3d(Eigen::Vector3d(xy->x(), xy->y(), 1.0).normalized()))
              : std::nullopt;
}

}  // namespace

Lens::Lens(const BrownLens& model) : model_(model), fold_(rational::foldR2(rational::asRational(model))) {
    requireLens(model.f_px, model.f_px + model.cx_px + model.cy_px + model.k1 + model.k2 + model.k3 +
                                model.p1 + model.p2);
}

Lens::Lens(const RationalLens& model) : model_(model), fold_(rational::foldR2(model)) {
    requireLens(model.f_px, model.f_px + model.cx_px + model.cy_px + model.k1 + model.k2 + model.k3 +
                                model.k4 + model.k5 + model.k6 + model.p1 + model.p2);
}

Lens::Lens(const FisheyeLens& model) : model_(model), fold_(fisheye::foldAngle_rad(model)) {
    requireLens(model.f_px,
                model.f_px + model.cx_px + model.cy_px + model.k1 + model.k2 + model.k3 + model.k4);
}

Lens::Lens(RadialTableLens model) {
    radial_table::requireMonotone(model);
    slopes_ = radial_table::slopes(model.rows);
    model_ = std::move(model);
}

Lens Lens::withResiduals(std::optional<ResidualTable> table) const {
    if (table) {
        table->requireUnfolded();
    }
    Lens lens = *this;
    lens.residuals_ = std::move(table);
    return lens;
}

core::Result<Eigen::Vector2d> Lens::pixelFromCamera(const Eigen::Vector3d& p_camera) const {
    const auto modelled = modelledPixel(p_camera);
    if (!modelled || !residuals_) {
        return modelled;
    }
    const auto seen = residuals_->seenFrom(*modelled);
    return seen ? core::Result<Eigen::Vector2d>(*seen) : outsideTheLens();
}

core::Result<Eigen::Vector3d> Lens::cameraFromPixel(const Eigen::Vector2d& px) const {
    const auto ray = modelledRay(residuals_ ? Eigen::Vector2d(px - residuals_->at(px)) : px);
    return ray ? core::Result<Eigen::Vector3d>(*ray) : outsideTheLens();
}

core::Result<Eigen::Vector2d> Lens::modelledPixel(const Eigen::Vector3d& p_camera) const {
    const double angle_rad = std::atan2(p_camera.head<2>().norm(), p_camera.z());
    const bool is_direction = p_camera.allFinite() && !p_camera.isZero(0);
    const auto bent = [&](const RationalLens& lens) -> std::optional<Eigen::Vector2d> {
        const auto xy = rational::distorted(lens, fold_, p_camera.head<2>() / p_camera.z());
        return xy ? std::optional(Eigen::Vector2d(lens.f_px * *xy)) : std::nullopt;
    };
    const auto outTo = [&](std::optional<double> radius_px) -> std::optional<Eigen::Vector2d> {
        return radius_px && is_direction
                   ? std::optional(Eigen::Vector2d(*radius_px * outwards(p_camera.head<2>())))
                   : std::nullopt;
    };
    const bool is_flat =
        std::holds_alternative<BrownLens>(model_) || std::holds_alternative<RationalLens>(model_);
    if (is_flat && !(p_camera.z() > 0)) {
        return behindTheCamera();
    }
    const auto from_centre_px =
        std::visit(Overloaded{[&](const BrownLens& lens) { return bent(rational::asRational(lens)); }, bent,
                              [&](const FisheyeLens& lens) {
                                  const auto radius = fisheye::radiusAtAngle(lens, fold_, angle_rad);
                                  return outTo(radius ? std::optional(lens.f_px * *radius) : std::nullopt);
                              },
                              [&](const RadialTableLens& table) {
                                  return outTo(radial_table::radiusAtAngle(table.rows, slopes_, angle_rad));
                              }},
                   model_);
    return from_centre_px ? core::Result<Eigen::Vector2d>(principalPoint() + *from_centre_px)
                          : outsideTheLens();
}

std::optional<Eigen::Vector3d> Lens::modelledRay(const Eigen::Vector2d& px) const {
    const Eigen::Vector2d from_centre_px = px - principalPoint();
    const double radius_px = from_centre_px.norm();
    const auto straightened = [&](const RationalLens& lens) {
        return upright(rational::undistorted(lens, fold_, from_centre_px / lens.f_px));
    };
    const auto tiltedBy = [&](std::optional<double> angle_rad) {
        return angle_rad ? std::optional(tilted(from_centre_px, *angle_rad)) : std::nullopt;
    };
    return std::visit(
        Overloaded{[&](const BrownLens& lens) { return straightened(rational::asRational(lens)); },
                   straightened,
                   [&](const FisheyeLens& lens) {
                       return tiltedBy(fisheye::angleAtRadius(lens, fold_, radius_px / lens.f_px));
                   },
                   [&](const RadialTableLens& table) {
                       return tiltedBy(radial_table::angleAtRadius(table.rows, slopes_, radius_px));
                   }},
        model_);
}

Eigen::Vector2d Lens::principalPoint() const {
    return std::visit([](const auto& lens) { return Eigen::Vector2d(lens.cx_px, lens.cy_px); }, model_);
}

double Lens::focalLengthPx() const {
    return std::visit(Overloaded{[this](const RadialTableLens&) { return 1.0 / slopes_.front(); },
                                 [](const auto& lens) { return lens.f_px; }},
                      model_);
}

double Lens::usableAngle_rad() const {
    return std::visit(Overloaded{[](const RadialTableLens& table) { return table.rows.back().angle_rad; },
                                 [this](const FisheyeLens&) { return fold_; },
                                 [this](const auto&) { return std::atan(std::sqrt(fold_)); }},
                      model_);
}

}  // namespace pmts::camera
