#include "pmts/camera/lens_difference.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pmts::camera {
namespace {

constexpr int kColumns = 33;
constexpr int kRows = 25;

struct RayPair {
    Eigen::Vector2d px;
    Eigen::Vector3d first, second;
};

std::vector<RayPair> rayPairs(const Lens& first, const Lens& second, int width_px, int height_px) {
    std::vector<RayPair> pairs;
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const Eigen::Vector2d px(column * (width_px - 1.0) / (kColumns - 1), row * (height_px - 1.0) / (kRows - 1));
            const auto one = first.cameraFromPixel(px);
            const auto other = second.cameraFromPixel(px);
            if (one && other) {
                pairs.push_back({px, *one, *other});
            }
        }
    }
    return pairs;
}

/// Turn that brings the second rays onto the first (Kabsch 1976).
Eigen::Matrix3d firstFromSecond(const std::vector<RayPair>& pairs) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const RayPair& pair : pairs) {
        sum += pair.first * pair.second.transpose();
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1.0 : 1.0;
    return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

/// carrier_from_camera without knowledge of how a mount's angles are composed: the pose over a level, north-looking telescope.
Eigen::Matrix3d carrierFromCamera(const Mount& mount) {
    return cameraPose(mount, {.ha = core::Angle::fromGon(0), .va = core::Angle::fromGon(100)}).station_from_camera;
}

/// The mount whose carrier_from_camera is this: Rz(-yaw) Rx(pitch) Ry(twist) times the upright camera's.
Mount turnedTo(Mount mount, const Eigen::Matrix3d& carrier_from_camera) {
    const Eigen::Matrix3d upright = carrierFromCamera(Mount{.kind = mount.kind});
    const Eigen::Matrix3d turn = carrier_from_camera * upright.transpose();
    mount.yaw = core::Angle::fromRad(std::atan2(turn(0, 1), turn(1, 1)));
    mount.pitch = core::Angle::fromRad(std::asin(std::clamp(turn(2, 1), -1.0, 1.0)));
    mount.twist = core::Angle::fromRad(std::atan2(-turn(2, 0), turn(2, 2)));
    return mount;
}

}  // namespace

core::Result<LensDifference> lensDifference(const Lens& first, const Lens& second, int width_px, int height_px) {
    constexpr double kLeastShare = 0.25;
    const std::vector<RayPair> pairs = rayPairs(first, second, width_px, height_px);
    LensDifference difference;
    difference.compared = static_cast<double>(pairs.size()) / (kColumns * kRows);
    if (difference.compared < kLeastShare) {
        return core::fail(core::ErrorKind::kUndefined,
                          QCoreApplication::translate("LensDifference", "The two lenses have too little of the picture in common."),
                          QCoreApplication::translate("LensDifference", "Compare lenses of the same camera and mode."));
    }
    difference.first_from_second = firstFromSecond(pairs);
    double sum_px2 = 0.0;
    for (const RayPair& pair : pairs) {
        // In the picture where the first lens has one, else as an angle times its focal length.
        const auto there = first.pixelFromCamera(difference.first_from_second * pair.second);
        const double apart_px =
            there ? (*there - pair.px).norm()
                  : first.focalLengthPx() * (difference.first_from_second * pair.second - pair.first).norm();
        sum_px2 += apart_px * apart_px;
        if (apart_px > difference.largest_px) {
            difference.largest_px = apart_px;
            difference.largest_at_px = pair.px;
        }
    }
    difference.rms_px = std::sqrt(sum_px2 / static_cast<double>(pairs.size()));
    return difference;
}

core::Result<Rig> withLens(const Rig& rig, const Lens& lens) {
    const auto difference = lensDifference(rig.lens, lens, rig.width_px, rig.height_px);
    PMTS_TRY(difference);
    Rig changed = rig;
    changed.lens = lens;
    changed.mount = turnedTo(rig.mount, carrierFromCamera(rig.mount) * difference->first_from_second);
    return changed;
}

}  // namespace pmts::camera
