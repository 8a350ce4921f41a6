#include "pmts/targeting/click_method.hpp"

#include "pmts/geometry/polar.hpp"

#include <Eigen/Geometry>
#include <QCoreApplication>

#include <cmath>

namespace pmts::targeting {
namespace {

using core::Result;
using geometry::Pointing;

constexpr double kFarAway_m = 1e6;
constexpr double kLeastShare = 0.4, kShareStep = 0.05;  ///< of the picture's half width

QString sentence(const char* text) { return QCoreApplication::translate("ClickMethod", text); }

/// Angle between the rays of two pixels, by the pixels between them.
Result<core::Angle> meanPixelAngle(const camera::Lens& lens, const Eigen::Vector2d& a_px, const Eigen::Vector2d& b_px) {
    const auto a = lens.cameraFromPixel(a_px);
    PMTS_TRY(a);
    const auto b = lens.cameraFromPixel(b_px);
    PMTS_TRY(b);
    return core::Angle::fromRad(std::atan2(a->cross(*b).norm(), a->dot(*b))) / (b_px - a_px).norm();
}

/// The same over as much of the line as the lens describes: a distortion table may end before the picture's edge.
Result<core::Angle> meanPixelAngleWithin(const camera::Lens& lens, const Eigen::Vector2d& a_px, const Eigen::Vector2d& b_px) {
    const Eigen::Vector2d middle_px = (a_px + b_px) / 2;
    for (double share = 1.0; share > kLeastShare; share -= kShareStep) {
        if (const auto angle = meanPixelAngle(lens, middle_px + share * (a_px - middle_px), middle_px + share * (b_px - middle_px))) {
            return angle;
        }
    }
    return meanPixelAngle(lens, a_px, b_px);  // says why not
}

Result<AveragePixelAngle> meanPixelAngle(const camera::Rig& rig) {
    const double right = rig.width_px - 1.0;
    const double bottom = rig.height_px - 1.0;
    const auto horizontal = meanPixelAngleWithin(rig.lens, {0, bottom / 2}, {right, bottom / 2});
    PMTS_TRY(horizontal);
    const auto vertical = meanPixelAngleWithin(rig.lens, {right / 2, 0}, {right / 2, bottom});
    PMTS_TRY(vertical);
    return AveragePixelAngle{*horizontal, *vertical};
}

/// The rig's own distortion table where one was measured, else one made from its lens; about the photo's centre.
std::optional<camera::RadialTableLens> tableOf(const camera::Rig& rig, const Eigen::Vector2d& centre_px) {
    if (const auto* measured = std::get_if<camera::RadialTableLens>(&rig.lens.model())) {
        return camera::RadialTableLens{.cx_px = centre_px.x(), .cy_px = centre_px.y(), .rows = measured->rows};
    }
    return tableFromLens(rig.lens, centre_px, std::hypot(rig.width_px, rig.height_px));
}

Result<Pointing> rectified(const ThesisCamera& camera, const camera::Rig& rig, const Eigen::Vector2d& px,
                           const Pointing& at, double slope_distance_m) {
    const auto table = tableOf(rig, camera.centre_px);
    if (!table) {
        return core::fail(core::ErrorKind::kUndefined, sentence("The lens of this rig gives no distortion table."),
                          sentence("Choose the rigorous method or another rig profile."));
    }
    return rectifiedOatpa(camera, *table, at, px, slope_distance_m);
}

}  // namespace

QString methodName(Method method) {
    switch (method) {
        case Method::kApa: return sentence("APA");
        case Method::kTpa: return sentence("TPA");
        case Method::kOatpa: return sentence("OATPA");
        case Method::kRectifiedOatpa: return sentence("Rectified OATPA");
        case Method::kRigorous: break;
    }
    return sentence("Rigorous");
}

QString methodError(Method method) {
    switch (method) {
        case Method::kApa: return sentence("up to 1.47 gon on the thesis's photo: every pixel counts as the mean pixel");
        case Method::kTpa: return sentence("up to 1.76 gon on the thesis's photo: no distortion, no offset");
        case Method::kOatpa: return sentence("up to 1.71 gon on the thesis's photo: no distortion");
        case Method::kRectifiedOatpa: return sentence("up to 0.06 gon as the thesis prints it: angles are added, not rotated");
        case Method::kRigorous: break;
    }
    return sentence("none of its own: what is left is the calibration and the click");
}

Result<ThesisCamera> thesisCamera(const PixelToPointing& model, const Pointing& at) {
    const auto centre = model.reticlePixel(at, kFarAway_m);
    PMTS_TRY(centre);
    const auto angle = meanPixelAngle(model.rig());
    PMTS_TRY(angle);
    const Eigen::Vector3d& offset_m = model.rig().mount.offset_m;
    return ThesisCamera{.centre_px = *centre,
                        .pixel_angle = *angle,
                        .f_px = model.rig().lens.focalLengthPx(),
                        .forward_m = offset_m.y(),
                        .up_m = offset_m.z()};
}

Result<Pointing> pointingOfClick(const ClickMethod& method, const PixelToPointing& model, const Eigen::Vector2d& px,
                                 const Pointing& at, double slope_distance_m) {
    if (method.method == Method::kRigorous) {
        return model.pointingForPixel(px, at, slope_distance_m).map([&at](const Pointing& pointing) {
            return geometry::inFaceOf(at, pointing);
        });
    }
    if (geometry::isFaceTwo(at)) {
        return core::fail(core::ErrorKind::kUndefined,
                          sentence("The method %1 holds in face I only.").arg(methodName(method.method)),
                          sentence("Change the face or choose the rigorous method."));
    }
    auto camera = thesisCamera(model, at);
    PMTS_TRY(camera);
    camera->pixel_angle = method.measured_pixel_angle.value_or(camera->pixel_angle);
    switch (method.method) {
        case Method::kApa: return apa(*camera, at, px);
        case Method::kTpa: return tpa(*camera, at, px);
        case Method::kOatpa: return oatpa(*camera, at, px, slope_distance_m);
        default: return rectified(*camera, model.rig(), px, at, slope_distance_m);
    }
}

}  // namespace pmts::targeting
