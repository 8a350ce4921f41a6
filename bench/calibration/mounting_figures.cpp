#include "mounting_figures.hpp"

#include "pmts/calibration/distortion_table.hpp"
#include "pmts/calibration/mount_check.hpp"
#include "pmts/calibration/mount_fit.hpp"
#include "pmts/calibration/plumb_line.hpp"
#include "pmts/core/virtual_clock.hpp"
#include "pmts/simulator/scene_camera.hpp"
#include "pmts/simulator/simulated_rig.hpp"
#include "pmts/targeting/bring_pixel.hpp"
#include "pmts/targeting/snap.hpp"
#include "pmts/targeting/spot_sweep.hpp"
#include "support/fake_total_station.hpp"
#include "support/figure.hpp"
#include "support/run_to_end.hpp"
#include "support/scene_frames.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pmts::bench {
namespace {

using core::Angle;
using geometry::Pointing;

std::shared_ptr<const simulator::Scene> laboratory() {
    return std::make_shared<const simulator::Scene>(simulator::Scene::named(QStringLiteral("laboratory"), 1).value());
}

bool failed(const char* what, const core::Error& error) {
    std::fprintf(stderr, "%s: %s\n", what, qPrintable(error.sentence()));
    return false;
}

cv::Mat seen(const std::shared_ptr<const simulator::Scene>& scene, const camera::Rig& rig, const Pointing& at, unsigned seed) {
    auto truth = std::make_shared<simulator::TruePointing>();
    truth->place(at);
    return simulator::SceneCamera(scene, truth, rig, {.noise_sigma = 2.0, .seed = seed}).draw({}).image.clone();
}

/// The user knows the camera but for its twist.
bool twistFigure(const std::shared_ptr<const simulator::Scene>& scene) {
    double worst_mgon = 0;
    unsigned seed = 1;
    for (const auto lens : {simulator::CameraLens::kBrown, simulator::CameraLens::kThesis}) {
        for (const double twist_gon : {-3.0, -0.4, 0.0, 0.8, 2.5}) {
            for (const double ha_gon : {262.0, 270.0, 276.0}) {
                for (const double va_gon : {92.0, 100.0, 107.0}) {
                    camera::Rig truth = simulator::simulatedRig({.lens = lens});
                    truth.mount.twist = Angle::fromGon(twist_gon);
                    const Pointing at{Angle::fromGon(ha_gon), Angle::fromGon(va_gon)};
                    const auto line = calibration::findPlumbLine(seen(scene, truth, at, ++seed), truth.lens);
                    if (!line) {
                        return failed("plumb line", line.error());
                    }
                    camera::Rig believed = truth;
                    believed.mount.twist = Angle();
                    const auto twist = calibration::twistFromLine(*line, believed, at);
                    if (!twist) {
                        return failed("twist", twist.error());
                    }
                    worst_mgon = std::max(worst_mgon, std::abs(twist->twist.mgon() - 1000 * twist_gon));
                }
            }
        }
    }
    figure("calibration.twist_plumb_line_worst", worst_mgon, "mgon", Wanted::kAtMost, 10.0);
    return true;
}

geometry::PolarPoint markNamed(const simulator::Scene& scene, const char* name) {
    const auto mark = std::find_if(scene.marks().begin(), scene.marks().end(),
                                   [name](const simulator::Mark& m) { return m.name == QLatin1String(name); });
    return geometry::polarFromStation(mark->p_station_m).value();
}

/// A mark clicked roughly and snapped, the telescope on it.
std::optional<calibration::Sighting> snappedMark(const std::shared_ptr<const simulator::Scene>& scene, const camera::Rig& truth,
                                                 const char* name, unsigned seed) {
    const geometry::PolarPoint target = markNamed(*scene, name);
    const auto about = camera::pixelFromStation(truth, target.pointing, geometry::stationFromPolar(target));
    const auto candidate = targeting::snapped(seen(scene, truth, target.pointing, seed), *about + Eigen::Vector2d(4, -3));
    if (!candidate) {
        return std::nullopt;
    }
    return calibration::Sighting{.px = candidate->px, .at = target.pointing, .target = target};
}

bool parallaxFigure(const std::shared_ptr<const simulator::Scene>& scene) {
    double worst_mm = 0, gap_worst_mm = 0;
    for (unsigned error = 0; error < 6; ++error) {
        const camera::Rig truth = simulator::simulatedRig({.rig_error = error});
        camera::Rig believed = simulator::simulatedRig();
        believed.mount.offset_m = {0, 0.085, 0};  // with the ruler
        believed.mount.twist = truth.mount.twist;  // taken out before
        const auto far = snappedMark(scene, truth, "2D", 10 + error);
        const auto near = snappedMark(scene, truth, "D", 20 + error);
        if (!far || !near) {
            std::fprintf(stderr, "a board's mark was not found\n");
            return false;
        }
        const auto fit = calibration::fitMount({*far, *near}, believed, {.others_are_known = true});
        const auto gap = calibration::gapAtNearBoard(believed, *far, *near);
        if (!fit || !gap) {
            return false;
        }
        for (const int axis : {0, 2}) {
            worst_mm = std::max(worst_mm, 1000 * std::abs(fit->mount.offset_m(axis) - truth.mount.offset_m(axis)));
        }
        gap_worst_mm = std::max(gap_worst_mm, 1000 * std::abs(gap->offset_m.x() - truth.mount.offset_m.x()));
    }
    figure("calibration.parallax_boards_worst", worst_mm, "mm", Wanted::kAtMost, 2.0);
    figure("calibration.parallax_gap_doubled_worst", gap_worst_mm, "mm", Wanted::kAtMost, 2.0);
    return true;
}

struct Measured {
    std::vector<calibration::TableCurve> curves;
    std::size_t pointings = 0;
    double seconds = 0.0;
};

/// Leads one target of the laboratory along two radii, as the program does: sweep, then angles off the axis.
bool sweepTarget(const std::shared_ptr<const simulator::Scene>& scene, const camera::Rig& truth, const camera::Rig& believed,
                 const char* name, unsigned seed, Measured& all) {
    core::VirtualClock clock;
    auto pointing = std::make_shared<simulator::TruePointing>();
    test::FakeTotalStation station(clock, pointing, {.servo_cc = 4.0, .reading_cc = 1.0, .seed = seed});
    auto camera = std::make_shared<simulator::SceneCamera>(scene, pointing, truth, simulator::CameraFaults{.noise_sigma = 2.0, .seed = seed});
    test::SceneFrames frames(clock, camera);
    const geometry::PolarPoint target = markNamed(*scene, name);
    pointing->place(target.pointing);
    const targeting::PixelToPointing model(believed);
    const auto clicked = camera::pixelFromStation(truth, target.pointing, geometry::stationFromPolar(target));
    const auto planned = calibration::plannedSpots(
        believed, {calibration::RadiusDirection::kRight, calibration::RadiusDirection::kLeft}, 30, 18);
    std::vector<Pointing> pointings;
    for (const calibration::PlannedSpot& spot : planned) {
        if (const auto at = targeting::pointingToBring(model, *clicked, spot.px, target.pointing, target.slope_distance_m)) {
            pointings.push_back(*at);
        }
    }
    targeting::SpotSweep sweep(station, frames.source(), targeting::findHere(targeting::PatchMatcher()), model, clock);
    const targeting::Click click{.frame = frames.now(), .at = target.pointing, .px = *clicked, .slope_distance_m = target.slope_distance_m};
    const core::Duration began = clock.now();
    std::stop_source nobody;
    const auto swept = test::runToEnd(sweep.run(click, pointings, nobody.get_token()), clock, std::chrono::minutes(30));
    if (!swept || !*swept) {
        return swept ? failed(name, swept->error()) : false;
    }
    calibration::TableRun run{.target = target, .spots = {}};
    for (const targeting::SpotSighting& sighting : (*swept)->sightings) {
        run.spots.push_back({sighting.px, sighting.at});
    }
    const auto curves = calibration::curvesOfRun(run, believed);
    if (!curves) {
        return failed(name, curves.error());
    }
    all.curves.insert(all.curves.end(), curves->begin(), curves->end());
    all.pointings += pointings.size();
    all.seconds += std::chrono::duration<double>(clock.now() - began).count();
    return true;
}

double rmsOff_px(const camera::RadialTableLens& table, const camera::Lens& truth) {
    double squares = 0;
    int count = 0;
    for (double radius_px = 4; radius_px < table.rows.back().radius_px; radius_px += 4, ++count) {
        const double angle = calibration::angleAt_rad(table, radius_px).value();
        const Eigen::Vector2d px = truth.pixelFromCamera({std::sin(angle), 0, std::cos(angle)}).value();
        squares += std::pow((px - truth.principalPoint()).norm() - radius_px, 2);
    }
    return std::sqrt(squares / count);
}

std::optional<calibration::DistortionTable> tableOf(const std::shared_ptr<const simulator::Scene>& scene, simulator::CameraLens lens,
                                                    double f_px, Measured& measured) {
    camera::Rig truth = simulator::simulatedRig({.lens = lens});
    camera::Rig believed = truth;  // offset and principal point known, the lens and the small angles only roughly
    const Eigen::Vector2d centre = truth.lens.principalPoint();
    believed.lens = camera::Lens(camera::BrownLens{.f_px = f_px, .cx_px = centre.x(), .cy_px = centre.y()});
    believed.mount.yaw += Angle::fromGon(0.1);
    believed.mount.twist = Angle();
    unsigned seed = 1;
    for (const char* name : {"T1", "T2", "T3"}) {
        if (!sweepTarget(scene, truth, believed, name, ++seed, measured)) {
            return std::nullopt;
        }
    }
    const auto table = calibration::tableOfCurves(measured.curves, centre, 30);
    if (!table) {
        failed("table", table.error());
        return std::nullopt;
    }
    return *table;
}

bool tableFigures(const std::shared_ptr<const simulator::Scene>& scene) {
    Measured brown, thesis;
    const auto brown_table = tableOf(scene, simulator::CameraLens::kBrown, 1380, brown);
    const auto thesis_table = tableOf(scene, simulator::CameraLens::kThesis, 775, thesis);
    if (!brown_table || !thesis_table) {
        return false;
    }
    figure("calibration.table_rms", rmsOff_px(brown_table->lens, simulator::simulatedRig().lens), "px", Wanted::kAtMost, 0.1);
    figure("calibration.table_thesis_lens_rms", rmsOff_px(thesis_table->lens, simulator::thesisLens()), "px", Wanted::kAtMost, 0.1);
    const double width = calibration::centralPixelWidth_rad(thesis_table->lens.rows);
    const double off = calibration::idealLineAngle_rad(width, 290) - calibration::angleAt_rad(thesis_table->lens, 290).value();
    const double deviation_gon = Angle::fromRad(off).gon();
    figure("calibration.table_deviation_at_290_of_1.48121", std::abs(deviation_gon - 1.48121), "gon", Wanted::kAtMost, 0.02);
    double apart = 0;
    for (const double spread : thesis_table->spread_rad) {
        apart = std::max(apart, spread);
    }
    figure("calibration.table_distances_apart", Angle::fromRad(apart).gon(), "gon", Wanted::kAtMost, 0.1);
    figure("calibration.table_time_per_target", thesis.seconds / 3, "s", Wanted::kAtMost, 180);
    return true;
}

/// Verdicts right of ten tilts on each mount.
bool mountFigure() {
    const auto square = std::make_shared<const simulator::Scene>(simulator::Scene::townSquare(1));
    int right = 0;
    unsigned seed = 1;
    for (const camera::MountKind kind : {camera::MountKind::kTelescope, camera::MountKind::kHandle}) {
        const camera::Rig truth = simulator::simulatedRig({.mount = kind});
        for (int i = 0; i < 10; ++i) {
            const Pointing before{Angle::fromGon(40.0 * i), Angle::fromGon(98)};
            const Pointing after{before.ha, Angle::fromGon(101)};
            const cv::Mat first = seen(square, truth, before, ++seed);
            const cv::Mat second = seen(square, truth, after, ++seed);
            const auto verdict = calibration::mountFromMotion(first, before, second, after, simulator::simulatedRig());
            right += verdict && verdict->kind == kind ? 1 : 0;
        }
    }
    figure("calibration.mount_kind_right", right, "of 20", Wanted::kAtLeast, 20);
    return true;
}

}  // namespace

bool mountingFigures() {
    const auto scene = laboratory();
    const bool all[] = {mountFigure(), twistFigure(scene), parallaxFigure(scene), tableFigures(scene)};
    return std::all_of(std::begin(all), std::end(all), [](bool good) { return good; });
}

}  // namespace pmts::bench
