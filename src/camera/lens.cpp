#include "pmts/camera/lens.hpp"

#include "brown.hpp"
#include "radial_table.hpp"

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

}  // namespace

Lens::Lens(const BrownLens& model) : model_(model), fold_r2_(brown::foldR2(model)) {
    const double sum =
        model.f_px + model.cx_px + model.cy_px + model.k1 + model.k2 + model.k3 + model.p1 + model.p2;
    if (!(model.f_px > 0) || !std::isfinite(sum)) {
        throw std::logic_error("a lens has a positive focal length and finite parameters");
    }
}

Lens::Lens(RadialTableLens model) {
    radial_table::requireMonotone(model);
    slopes_ = radial_table::slopes(model.rows);
    model_ = std::move(model);
}

core::Result<Eigen::Vector2d> Lens::pixelFromCamera(const Eigen::Vector3d& p_camera) const {
    if (const auto* table = std::get_if<RadialTableLens>(&model_)) {
        const double across = p_camera.head<2>().norm();
        const auto radius_px =
            radial_table::radiusAtAngle(table->rows, slopes_, std::atan2(across, p_camera.z()));
        if (!radius_px || !p_camera.allFinite() || p_camera.isZero(0)) {
            return outsideTheLens();
        }
        const Eigen::Vector2d outward =
            across > 0 ? Eigen::Vector2d(p_camera.head<2>() / across) : Eigen::Vector2d::Zero();
        return Eigen::Vector2d(principalPoint() + *radius_px * outward);
    }
    if (!(p_camera.z() > 0)) {
        return behindTheCamera();
    }
    const auto& lens = std::get<BrownLens>(model_);
    const auto distorted = brown::distorted(lens, fold_r2_, p_camera.head<2>() / p_camera.z());
    if (!distorted) {
        return outsideTheLens();
    }
    return Eigen::Vector2d(principalPoint() + lens.f_px * *distorted);
}

core::Result<Eigen::Vector3d> Lens::cameraFromPixel(const Eigen::Vector2d& px) const {
    const Eigen::Vector2d from_centre_px = px - principalPoint();
    if (const auto* table = std::get_if<RadialTableLens>(&model_)) {
        const double radius_px = from_centre_px.norm();
        const auto angle_rad = radial_table::angleAtRadius(table->rows, slopes_, radius_px);
        if (!angle_rad) {
            return outsideTheLens();
        }
        const Eigen::Vector2d outward =
            radius_px > 0 ? Eigen::Vector2d(from_centre_px / radius_px) : Eigen::Vector2d::Zero();
        const Eigen::Vector2d across = std::sin(*angle_rad) * outward;
        return Eigen::Vector3d(across.x(), across.y(), std::cos(*angle_rad));
    }
    const auto& lens = std::get<BrownLens>(model_);
    const auto xy = brown::undistorted(lens, fold_r2_, from_centre_px / lens.f_px);
    if (!xy) {
        return outsideTheLens();
    }
    return Eigen::Vector3d(Eigen::Vector3d(xy->x(), xy->y(), 1.0).normalized());
}

Eigen::Vector2d Lens::principalPoint() const {
    return std::visit([](const auto& lens) { return Eigen::Vector2d(lens.cx_px, lens.cy_px); }, model_);
}

double Lens::focalLengthPx() const {
    const auto* brown = std::get_if<BrownLens>(&model_);
    return brown != nullptr ? brown->f_px : 1.0 / slopes_.front();
}

double Lens::usableAngle_rad() const {
    const auto* table = std::get_if<RadialTableLens>(&model_);
    return table != nullptr ? table->rows.back().angle_rad : std::atan(std::sqrt(fold_r2_));
}

}  // namespace pmts::camera
