#include "pmts/calibration/plumb_line.hpp"

#include "pmts/geometry/frames.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::calibration {
namespace {

using core::Angle;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t kLeastPlaces = 10;
constexpr double kShortest_px = 40.0;
constexpr double kLeastLever = 0.05;  ///< sine of the angle between the optical axis and the line
constexpr int kRounds = 4;
constexpr double kWrong = 3.0;        ///< times the rms: thrown out

core::Error undefined(const char* happened, const char* remedy) {
    const auto text = [](const char* words) { return QCoreApplication::translate("PlumbLine", words); };
    return {.kind = core::ErrorKind::kUndefined, .happened = text(happened), .remedy = text(remedy), .info_code = {}, .detail = {}};
}

struct PlaneThroughCentre {
    Vector3d normal = Vector3d::UnitX();  ///< camera frame
    double rms_px = 0.0;
    double spread_px = 0.0;  ///< root mean square of the places along the line
    int places = 0;
};

/// Smallest principal direction of the rays, without those that lie wrong.
PlaneThroughCentre planeOf(const std::vector<Vector3d>& rays, double f_px) {
    PlaneThroughCentre plane;
    double within = 1.0;
    for (int round = 0; round < kRounds; ++round) {
        Matrix3d moments = Matrix3d::Zero();
        std::vector<const Vector3d*> used;
        for (const Vector3d& ray : rays) {
            if (round == 0 || std::abs(ray.dot(plane.normal)) <= within) {
                moments += ray * ray.transpose();
                used.push_back(&ray);
            }
        }
        const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(moments);
        plane.normal = axes.eigenvectors().col(0);
        const auto n = static_cast<double>(used.size());
        double squares = 0;
        for (const Vector3d* ray : used) {
            squares += std::pow(ray->dot(plane.normal), 2);
        }
        const double rms = std::sqrt(squares / n);
        within = kWrong * std::max(rms, 1e-6);
        plane.rms_px = f_px * rms;
        plane.spread_px = f_px * std::sqrt(axes.eigenvalues()(1) / n);
        plane.places = static_cast<int>(used.size());
    }
    return plane;
}

/// The twist t with up . M Ry(t) normal = 0, the one nearest to `about`.
std::optional<double> twistThatLevels(const Vector3d& up, const Vector3d& normal, double about) {
    const double a = up.x() * normal.x() + up.z() * normal.z();
    const double b = up.x() * normal.z() - up.z() * normal.x();
    const double c = up.y() * normal.y();
    const double lever = std::hypot(a, b);
    if (lever < kLeastLever || std::abs(c) > lever) {
        return std::nullopt;
    }
    const double middle = std::atan2(b, a);
    const double half = std::acos(-c / lever);
    const auto away = [about](double t) { return std::abs(std::remainder(t - about, 2 * M_PI)); };
    const double nearest = away(middle + half) < away(middle - half) ? middle + half : middle - half;
    return std::remainder(nearest, 2 * M_PI);
}

}  // namespace

core::Result<TwistFromLine> twistFromLine(const PictureLine& line, const camera::Rig& rig, const geometry::Pointing& at) {
    std::vector<Vector3d> rays;
    for (const Eigen::Vector2d& px : line.places_px) {
        if (const auto ray = rig.lens.cameraFromPixel(px)) {
            rays.push_back(*ray);
        }
    }
    if (rays.size() < kLeastPlaces || line.length_px < kShortest_px) {
        return tl::unexpected(undefined("Too little of the line is to be seen.", "Turn until it runs through the whole picture."));
    }
    const PlaneThroughCentre plane = planeOf(rays, rig.lens.focalLengthPx());
    camera::Mount untwisted = rig.mount;
    untwisted.twist = Angle();
    // M Ry(t) P is the camera's pose; P only exchanges the axes, and with t = 0 the pose is M P.
    Matrix3d carrier_from_upright;
    carrier_from_upright << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    const Matrix3d m = camera::cameraPose(untwisted, at).station_from_camera * carrier_from_upright.transpose();
    const auto twist = twistThatLevels(m.row(2).transpose(), carrier_from_upright * plane.normal, rig.mount.twist.rad());
    if (!twist) {
        return tl::unexpected(undefined("The camera looks along the plumb line.", "Turn VA towards the horizon."));
    }
    const double sigma = plane.rms_px / (plane.spread_px * std::sqrt(static_cast<double>(plane.places)));
    return TwistFromLine{.twist = Angle::fromRad(*twist), .sigma = Angle::fromRad(sigma), .unrest_px = plane.rms_px,
                         .places = plane.places};
}

}  // namespace pmts::calibration
