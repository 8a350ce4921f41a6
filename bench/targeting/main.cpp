#include "pmts/targeting/pixel_to_pointing.hpp"
#include "pmts/targeting/thesis_methods.hpp"
#include "support/figure.hpp"
#include "targeting/icsm_table.hpp"

#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace pmts;

namespace {

double missed_gon(const geometry::Pointing& computed, const geometry::Pointing& printed) {
    return std::max(core::abs(core::normalizedSigned(computed.ha - printed.ha)),
                    core::abs(computed.va - printed.va))
        .gon();
}

void printedTables() {
    double tpa_gon = 0;
    double oatpa_gon = 0;
    for (const auto& row : test::icsmTable()) {
        const targeting::ThesisCamera camera;
        tpa_gon = std::max(tpa_gon, missed_gon(targeting::tpa(camera, test::icsmPhoto(), row.px), row.tpa));
        const auto oatpa = targeting::oatpa(camera, test::icsmPhoto(), row.px, row.observed.slope_distance_m);
        oatpa_gon = std::max(oatpa_gon, missed_gon(oatpa.value(), row.oatpa));
    }
    bench::figure("targeting.tpa_table_max", tpa_gon, "gon", bench::Wanted::kAtMost, 0.010);
    bench::figure("targeting.oatpa_table_max", oatpa_gon, "gon", bench::Wanted::kAtMost, 0.010);
}

camera::Rig crookedRig(camera::MountKind kind) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 1500,
                                              .cx_px = 652,
                                              .cy_px = 349,
                                              .k1 = -0.2,
                                              .k2 = 0.06,
                                              .k3 = -0.01,
                                              .p1 = 8e-4,
                                              .p2 = -5e-4});
    rig.mount = {.kind = kind,
                 .offset_m = {0.02, 0.125, -0.035},
                 .yaw = core::Angle::fromGon(0.6),
                 .pitch = core::Angle::fromGon(1.7),
                 .twist = core::Angle::fromGon(-1.2)};
    return rig;
}

/// Turn about an axis through the origin, by OpenCV.
cv::Matx33d turn(const cv::Vec3d& axis, double angle_rad) {
    cv::Matx33d rotation;
    cv::Rodrigues(axis * angle_rad, rotation);
    return rotation;
}

/// The second opinion: none of our geometry, camera or lens code; turns by cv::Rodrigues, picture by
/// cv::projectPoints.
Eigen::Vector2d projectedByOpenCv(const camera::Rig& rig, const geometry::Pointing& at,
                                  const geometry::Pointing& target, double sd_m) {
    const cv::Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const auto& mount = rig.mount;
    cv::Matx33d carrier = turn(z, -at.ha.rad());
    if (mount.kind == camera::MountKind::kTelescope) {
        carrier = carrier * turn(x, M_PI / 2 - at.va.rad());
    }
    const cv::Matx33d body =
        carrier * turn(z, -mount.yaw.rad()) * turn(x, mount.pitch.rad()) * turn(y, mount.twist.rad());
    const cv::Matx33d camera_from_station = turn(x, M_PI / 2) * body.t();  // z up to y down
    const cv::Vec3d centre = carrier * cv::Vec3d(mount.offset_m.x(), mount.offset_m.y(), mount.offset_m.z());
    const cv::Vec3d point = sd_m * (turn(z, -target.ha.rad()) * turn(x, M_PI / 2 - target.va.rad()) * y);

    const auto& lens = std::get<camera::BrownLens>(rig.lens.model());
    const cv::Matx33d matrix(lens.f_px, 0, lens.cx_px, 0, lens.f_px, lens.cy_px, 0, 0, 1);
    cv::Vec3d rotation;
    cv::Rodrigues(camera_from_station, rotation);
    std::vector<cv::Point2d> pixels;
    cv::projectPoints(std::vector<cv::Point3d>{cv::Point3d(point)}, rotation, -(camera_from_station * centre),
                      matrix, std::vector<double>{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3}, pixels);
    return {pixels[0].x, pixels[0].y};
}

/// Pixel -> pointing by PMTS, pointing -> pixel by OpenCV, over the whole frame at tilts of -40 to 40 gon.
double openLoopRms_px(camera::MountKind kind) {
    const camera::Rig rig = crookedRig(kind);
    const targeting::PixelToPointing model(rig);
    double sum2_px2 = 0;
    int count = 0;
    for (double tilt_gon = -40; tilt_gon <= 40; tilt_gon += 10) {
        const geometry::Pointing at{core::Angle::fromGon(237.5), core::Angle::fromGon(100 - tilt_gon)};
        for (const double sd_m : {3.0, 15.0, 200.0}) {
            for (double v = 0; v < 720; v += 71.9) {
                for (double u = 0; u < 1280; u += 79.9) {
                    const auto target = model.pointingForPixel({u, v}, at, sd_m);
                    sum2_px2 += (projectedByOpenCv(rig, at, target.value(), sd_m) - Eigen::Vector2d(u, v))
                                    .squaredNorm();
                    ++count;
                }
            }
        }
    }
    return std::sqrt(sum2_px2 / count);
}

}  // namespace

int main() {
    printedTables();
    bench::figure("targeting.open_loop_telescope_rms", openLoopRms_px(camera::MountKind::kTelescope), "px",
                  bench::Wanted::kAtMost, 0.001);
    bench::figure("targeting.open_loop_handle_rms", openLoopRms_px(camera::MountKind::kHandle), "px",
                  bench::Wanted::kAtMost, 0.001);
}
