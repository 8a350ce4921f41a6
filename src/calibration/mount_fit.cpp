#include "pmts/calibration/mount_fit.hpp"

#include "pixel_residuals.hpp"
#include "pmts/geometry/frames.hpp"

#include <Eigen/SVD>
#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::calibration {
namespace {

using core::Angle;
using core::ErrorKind;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kFarOverNear = 1.5;
constexpr int kRounds = 30;
constexpr double kStep = 1e-6;  ///< rad and m
constexpr double kUnseen = 1e-4;  ///< of the largest singular value: at 4 and 8 m the weakest is 0.02

QString text(const char* sentence) { return QCoreApplication::translate("MountFit", sentence); }

Eigen::Matrix3d stationFromCarrier(camera::MountKind kind, const geometry::Pointing& at) {
    return kind == camera::MountKind::kTelescope ? geometry::stationFromTelescope(at) : geometry::stationFromAlidade(at.ha);
}

/// To the right and up for each metre forward, in the carrier's frame.
Vector2d tangents(const Vector3d& carrier) { return {carrier.x() / carrier.y(), carrier.z() / carrier.y()}; }

/// How far the camera's ray to the target and the telescope's are turned apart, to the right and up.
core::Result<Vector2d> between(const camera::Rig& rig, const Sighting& sighting) {
    const auto ray = rig.lens.cameraFromPixel(sighting.px);
    PMTS_TRY(ray);
    const Eigen::Matrix3d carrier_from_station = stationFromCarrier(rig.mount.kind, sighting.at).transpose();
    const Vector3d seen = carrier_from_station * camera::cameraPose(rig.mount, sighting.at).station_from_camera * *ray;
    const Vector3d sighted = carrier_from_station * geometry::directionFromPointing(sighting.target.pointing);
    return Vector2d(tangents(seen) - tangents(sighted));
}

/// The unknowns of a case: yaw, pitch, then the offsets sought.
class Unknowns {
public:
    Unknowns(const camera::Rig& initial, const OffsetCase& sought) : rig_(initial) {
        const std::array<bool, 3> free{sought.x, sought.y, sought.z};
        for (int axis = 0; axis < 3; ++axis) {
            if (free[static_cast<std::size_t>(axis)]) {
                axes_.push_back(axis);
            }
        }
        const Vector3d before = initial.mount.offset_m;
        if (!sought.others_are_known) {
            rig_.mount.offset_m.setZero();
        }
        values_ = VectorXd::Zero(2 + static_cast<Eigen::Index>(axes_.size()));
        values_(0) = initial.mount.yaw.rad();
        values_(1) = initial.mount.pitch.rad();
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            values_(static_cast<Eigen::Index>(i) + 2) = before(axes_[i]);
        }
    }
    [[nodiscard]] camera::Rig rigAt(const VectorXd& values) const {
        camera::Rig rig = rig_;
        rig.mount.yaw = Angle::fromRad(values(0));
        rig.mount.pitch = Angle::fromRad(values(1));
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            rig.mount.offset_m(axes_[i]) = values(static_cast<Eigen::Index>(i) + 2);
        }
        return rig;
    }
    [[nodiscard]] core::Result<VectorXd> residuals(const std::vector<Sighting>& sightings, const VectorXd& values) const {
        const camera::Rig rig = rigAt(values);
        VectorXd all(2 * static_cast<Eigen::Index>(sightings.size()));
        for (std::size_t i = 0; i < sightings.size(); ++i) {
            const auto off = pixelResidual(rig, sightings[i]);
            PMTS_TRY(off);
            all.segment<2>(2 * static_cast<Eigen::Index>(i)) = *off;
        }
        return all;
    }
    [[nodiscard]] core::Result<Eigen::MatrixXd> jacobian(const std::vector<Sighting>& sightings, const VectorXd& values) const {
        Eigen::MatrixXd slopes(2 * static_cast<Eigen::Index>(sightings.size()), values.size());
        for (Eigen::Index k = 0; k < values.size(); ++k) {
            VectorXd step = VectorXd::Zero(values.size());
            step(k) = kStep;
            const auto ahead = residuals(sightings, values + step);
            PMTS_TRY(ahead);
            const auto behind = residuals(sightings, values - step);
            PMTS_TRY(behind);
            slopes.col(k) = (*ahead - *behind) / (2 * kStep);
        }
        return slopes;
    }
    [[nodiscard]] const VectorXd& start() const { return values_; }
    [[nodiscard]] const std::vector<int>& axes() const { return axes_; }

private:
    camera::Rig rig_;
    std::vector<int> axes_;
    VectorXd values_;
};

}  // namespace

core::Result<BoardGap> gapAtNearBoard(const camera::Rig& rig, const Sighting& far, const Sighting& near) {
    const double near_m = near.target.slope_distance_m;
    const double far_m = far.target.slope_distance_m;
    if (!(near_m > 0.0) || far_m < kFarOverNear * near_m) {
        return core::fail(ErrorKind::kBadInput, text("The far board is not far enough behind the near one."),
                          text("Put it at twice the distance of the near board."));
    }
    const auto at_far = between(rig, far);
    PMTS_TRY(at_far);
    const auto at_near = between(rig, near);
    PMTS_TRY(at_near);
    const Vector2d gap_m = near_m * (*at_far - *at_near);
    return BoardGap{.near_m = near_m, .far_m = far_m, .gap_m = gap_m, .offset_m = gap_m * (far_m / (far_m - near_m))};
}

core::Result<MountFit> fitMount(const std::vector<Sighting>& sightings, const camera::Rig& initial, const OffsetCase& sought,
                                double pixel_sigma) {
    const Unknowns unknowns(initial, sought);
    VectorXd values = unknowns.start();
    if (2 * static_cast<Eigen::Index>(sightings.size()) < values.size()) {
        return core::fail(ErrorKind::kBadInput, text("There are too few sightings for these offsets."),
                          text("Sight both boards first."));
    }
    Eigen::MatrixXd covariance;
    VectorXd left;
    for (int round = 0; round < kRounds; ++round) {
        const auto residuals = unknowns.residuals(sightings, values);
        PMTS_TRY(residuals);
        const auto slopes = unknowns.jacobian(sightings, values);
        PMTS_TRY(slopes);
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(*slopes, Eigen::ComputeThinU | Eigen::ComputeThinV);
        const VectorXd& seen = svd.singularValues();
        if (seen(seen.size() - 1) < kUnseen * seen(0)) {
            return core::fail(ErrorKind::kUndefined, text("These sightings do not tell the offsets from the camera's direction."),
                              sought.y ? text("Sight the near board away from the cross-hair too.")
                                       : text("Sight a board at another distance."));
        }
        const VectorXd step = svd.solve(*residuals);
        values -= step;
        covariance = svd.matrixV() * seen.cwiseAbs2().cwiseInverse().asDiagonal() * svd.matrixV().transpose();
        left = *residuals;
        if (step.norm() < 1e-12) {
            break;
        }
    }
    MountFit fit{.mount = unknowns.rigAt(values).mount,
                 .rms_px = std::sqrt(left.squaredNorm() / static_cast<double>(left.size())),
                 .largest_px = left.lpNorm<Eigen::Infinity>(),
                 .offset_sigma_m = {}};
    for (std::size_t i = 0; i < unknowns.axes().size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i) + 2;
        fit.offset_sigma_m[static_cast<std::size_t>(unknowns.axes()[i])] = pixel_sigma * std::sqrt(covariance(k, k));
    }
    return fit;
}

NearBoardRange nearBoardRange(const BoardDistances& limits, double f_px) {
    return {.least_m = std::max(limits.telescope_close_m, limits.camera_close_m), .most_m = limits.offset_m * f_px};
}

}  // namespace pmts::calibration
