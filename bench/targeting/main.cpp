#include "clicks.hpp"
#include "pmts/targeting/pixel_to_pointing.hpp"
#include "pmts/targeting/thesis_methods.hpp"
#include "support/figure.hpp"
#include "targeting/icsm_table.hpp"
#include "targeting/pictures.hpp"

#include <QCoreApplication>
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

/// The calibrated camera of the click series, 1280x720.
camera::Rig trueRig() {
    camera::Rig rig = crookedRig(camera::MountKind::kTelescope);
    rig.mount.pitch = core::Angle::fromGon(0.7);
    return rig;
}

/// 2 % wrong in f, 0.3 gon in pitch and twist.
camera::Rig wrongRig() {
    camera::Rig rig = trueRig();
    auto lens = std::get<camera::BrownLens>(rig.lens.model());
    lens.f_px *= 1.02;
    rig.lens = camera::Lens(lens);
    rig.mount.pitch += core::Angle::fromGon(0.3);
    rig.mount.twist += core::Angle::fromGon(0.3);
    return rig;
}

double share(int part, int of) { return of > 0 ? 100.0 * part / of : 0.0; }

void told(const char* name, const bench::ClickOutcome& outcome) {
    std::printf(
        "# %s: %d clicks (%d more refused at the click), %d settled (%d in 2 moves, %d in 3), "
        "largest error %.3f px\n",
        name, outcome.clicks, outcome.refused, outcome.settled, outcome.settled_in_two,
        outcome.settled_in_three, outcome.largest_px);
    for (const auto& [why, count] : outcome.failures) {
        std::printf("#   %s: %d\n", why.c_str(), count);
    }
}

std::shared_ptr<const simulator::Scene> town() {
    return std::make_shared<const simulator::Scene>(simulator::Scene::townSquare(7));
}

void rightRig(int clicks) {
    const auto right = bench::runClicks(
        {.scene = town(), .true_rig = trueRig(), .believed_rig = trueRig(), .clicks = clicks, .seed = 11});
    told("natural texture", right);
    using enum bench::Wanted;
    bench::figure("targeting.open_loop_drawn_rms", right.open_loop_rms_px, "px", kAtMost, 0.5);
    bench::figure("targeting.recentred_rms", right.rms_px, "px", kAtMost, 0.1);
    bench::figure("targeting.recentred_rms_angle", right.rms_arcsec, "arcsec", kAtMost, 20);
    bench::figure("targeting.settled_in_2_moves", share(right.settled_in_two, right.clicks), "%", kAtLeast,
                  95);
    bench::figure("targeting.false_settled", share(right.wrong, right.settled), "%", kAtMost, 0.2);
    bench::figure("targeting.step_median", bench::median(right.step_ms), "ms", kAtMost, 30);
}

/// The reticle itself is drawn by the wrong rig: the spot is judged against where it is drawn.
void wrongRigSeries(int clicks) {
    const auto wrong = bench::runClicks(
        {.scene = town(), .true_rig = trueRig(), .believed_rig = wrongRig(), .clicks = clicks, .seed = 12});
    told("wrong rig", wrong);
    using enum bench::Wanted;
    bench::figure("targeting.wrong_rig_settled_in_3_moves", share(wrong.settled_in_three, wrong.clicks), "%",
                  kAtLeast, 95);
    bench::figure("targeting.wrong_rig_rms", wrong.rms_px, "px", kAtMost, 0.1);
    bench::figure("targeting.wrong_rig_false_settled", share(wrong.wrong, wrong.settled), "%", kAtMost, 0.2);
}

/// Rows of windows 1.2 m apart on a wall 30 m away, 60 px in the picture. Most are exactly alike; `different`
/// is the share of those with a blind half down or a flower box.
std::shared_ptr<const simulator::Scene> facade(double different, unsigned seed) {
    constexpr int kPitch_px = 60;  // 2 cm a texel
    cv::Mat wall = test::facadeOfWindows({3000, 1200}, kPitch_px);
    cv::RNG random(seed);
    for (int y = kPitch_px / 4; y + kPitch_px < wall.rows; y += kPitch_px) {
        for (int x = kPitch_px / 4; x + kPitch_px < wall.cols; x += kPitch_px) {
            if (random.uniform(0.0, 1.0) < different) {
                const cv::Scalar colour(random.uniform(30, 220), random.uniform(30, 220),
                                        random.uniform(30, 220));
                const int top = y + (random.uniform(0, 2) ? 0 : kPitch_px / 2);
                cv::rectangle(wall, {x + 2, top, kPitch_px / 2 - 4, random.uniform(8, 20)}, colour,
                              cv::FILLED);
            }
        }
    }
    return std::make_shared<const simulator::Scene>(std::vector{
        simulator::Panel{QStringLiteral("facade"), {-30, 30, -12}, {60, 0, 0}, {0, 0, 24}, wall}});
}

void repeatingFacade(int clicks) {
    int wrong = 0;
    int settled = 0;
    for (const double different : {0.0, 0.15}) {
        for (const camera::Rig& believed : {trueRig(), wrongRig()}) {
            const auto outcome = bench::runClicks({.scene = facade(different, 5),
                                                   .true_rig = trueRig(),
                                                   .believed_rig = believed,
                                                   .clicks = clicks / 4,
                                                   .seed = 13,
                                                   .most_tilt_gon = 10,
                                                   .most_ha_gon = 25,
                                                   .count_refused = true});
            told(different > 0 ? "facade, some windows different" : "facade, all windows alike", outcome);
            wrong += outcome.wrong;
            settled += outcome.settled;
        }
    }
    bench::figure("targeting.facade_wrong_targets", wrong, "of " + std::to_string(settled) + " settled",
                  bench::Wanted::kAtMost, 0);
}

/// Nothing is promised by a count nobody sees: each series prints its own.
int clicksAsked(const QStringList& arguments, int full, int usual) {
    return arguments.contains("--full") ? full : usual;
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    cv::setNumThreads(1);
    const int clicks = clicksAsked(app.arguments(), 500, 120);
    const int facade_clicks = clicksAsked(app.arguments(), 200, 80);
    std::printf("# %d clicks a series, %d on facades (--full: 500 and 200; --only right|wrong|facade)\n",
                clicks, facade_clicks);
    printedTables();
    const auto wanted = [&app](const char* series) {
        return !app.arguments().contains("--only") || app.arguments().contains(series);
    };
    if (wanted("right")) {
        rightRig(clicks);
    }
    if (wanted("wrong")) {
        wrongRigSeries(clicks);
    }
    if (wanted("facade")) {
        repeatingFacade(facade_clicks);
    }
    bench::figure("targeting.open_loop_telescope_rms", openLoopRms_px(camera::MountKind::kTelescope), "px",
                  bench::Wanted::kAtMost, 0.001);
    bench::figure("targeting.open_loop_handle_rms", openLoopRms_px(camera::MountKind::kHandle), "px",
                  bench::Wanted::kAtMost, 0.001);
}
