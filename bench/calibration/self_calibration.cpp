#include "self_calibration.hpp"

#include "calibration/sweeps.hpp"
#include "drawn_sweep.hpp"
#include "pmts/simulator/simulated_rig.hpp"
#include "support/figure.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

namespace pmts::bench {
namespace {

using calibration::SelfCalibration;
using calibration::SweptSpot;

constexpr int kFarPointings = 36;  // 24 of them scout
constexpr int kNearPointings = 24;
constexpr double kMatcher_px = 0.015;  // what the drawn series below measure
constexpr double kFar_m = 22.0;
constexpr double kNear_m = 5.0;

struct Series {
    std::vector<double> held_out_px, f_percent, angles_mgon, offsets_mm, frame_px, solve_s;
    int failed = 0;
};

void judge(Series& series, const camera::Rig& truth, const SelfCalibration& found) {
    const camera::Mount& mount = found.rig.mount;
    const auto off_mgon = [](core::Angle a, core::Angle b) { return std::abs((a - b).gon()) * 1e3; };
    series.held_out_px.push_back(found.held_out_px);
    series.f_percent.push_back(100 *
                               std::abs(found.rig.lens.focalLengthPx() / truth.lens.focalLengthPx() - 1));
    series.angles_mgon.push_back(
        std::max({off_mgon(mount.yaw, truth.mount.yaw), off_mgon(mount.pitch, truth.mount.pitch),
                  off_mgon(mount.twist, truth.mount.twist)}));
    series.offsets_mm.push_back(1e3 * (mount.offset_m - truth.mount.offset_m).lpNorm<Eigen::Infinity>());
    series.frame_px.push_back(test::frameError_px(truth, found.rig));
}

void solve(Series& series, const camera::Rig& truth, const camera::Rig& start,
           const std::vector<SweptSpot>& spots) {
    const auto begin = std::chrono::steady_clock::now();
    const auto found = calibration::selfCalibrate(spots, {.start = start});
    series.solve_s.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    if (!found) {
        ++series.failed;
        std::printf("# %s\n", qPrintable(found.error().sentence()));
        return;
    }
    judge(series, truth, *found);
}

/// Two spots as a matcher of this noise sees them, circles at 3 cc, ranges at 3 mm.
Series noisySeries(simulator::CameraLens lens, int seeds, double noise_px) {
    Series series;
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto truth = simulator::simulatedRig({.lens = lens, .rig_error = static_cast<unsigned>(seed)});
        const camera::Rig start = test::dataSheetRig(truth);
        const test::SweepNoise noise{.px = noise_px, .seed = static_cast<unsigned>(seed)};
        std::vector<SweptSpot> spots{
            test::scoutedSweepOf(truth, start, test::spotAt(20, 97, kFar_m), noise, kFarPointings)};
        const auto rough = calibration::roughRig(spots, start).value_or(start);
        spots.push_back(test::sweepOf(truth, rough, test::spotAt(60, 101, kNear_m),
                                      {.px = noise_px, .seed = noise.seed + 900},
                                      {.most_pointings = kNearPointings}));
        solve(series, truth, start, spots);
    }
    return series;
}

Series drawnSeries(simulator::CameraLens lens, int seeds) {
    Series series;
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto truth = simulator::simulatedRig({.lens = lens, .rig_error = static_cast<unsigned>(seed)});
        const camera::Rig start = test::dataSheetRig(truth);
        DrawnSweeps sweeps(truth, static_cast<unsigned>(seed));
        const auto spots = sweeps.run(start, {kFar_m, kNear_m}, {kFarPointings, kNearPointings});
        std::printf("# drawn, seed %d: %zu pictures, %d missed, matcher against the truth %.3f px rms\n",
                    seed, sweeps.pictures(), sweeps.missed(), sweeps.matcherRms_px());
        if (spots.size() == 2) {
            solve(series, truth, start, spots);
        } else {
            ++series.failed;
        }
    }
    return series;
}

void tell(const std::string& name, const std::vector<double>& values, const char* unit, double target) {
    if (values.empty()) {
        return;
    }
    figure("calibration." + name, median(values), unit, Wanted::kAtMost, target);
    std::printf("#   worst of %zu: %.4g %s\n", values.size(), quantile(values, 1.0), unit);
}

void contained(const std::string& how, const Series& series) {
    tell(how + "_held_out", series.held_out_px, "px", 0.05);
    tell(how + "_f_error", series.f_percent, "%", 0.05);
    tell(how + "_angle_error", series.angles_mgon, "mgon", 3);
    tell(how + "_offset_error", series.offsets_mm, "mm", 2);
    tell(how + "_frame_error", series.frame_px, "px", 0.05);
}

/// A lens the model does not contain: the table of residuals does the rest.
void bent(const std::string& how, const Series& series) {
    tell(how + "_held_out", series.held_out_px, "px", 0.1);
    tell(how + "_frame_error", series.frame_px, "px", 0.1);
    figure("calibration." + how + "_failed", series.failed, "", Wanted::kAtMost, 0);
}

void planned() {
    const camera::Rig rig = simulator::simulatedRig();
    const Eigen::Vector3d p_station = geometry::stationFromPolar(test::spotAt(20, 97, kFar_m));
    const auto plan = calibration::planSweep(rig, p_station);
    const double time_s = std::chrono::duration<double>(plan->instrument_time).count();
    figure("calibration.pointings", static_cast<double>(plan->pointings.size()), "", Wanted::kAtMost, 60);
    figure("calibration.instrument_time", time_s, "s", Wanted::kAtMost, 180);
}

}  // namespace

void selfCalibration() {
    using enum simulator::CameraLens;
    planned();
    contained("self", noisySeries(kBrown, 12, kMatcher_px));
    tell("self_rational_frame_error", noisySeries(kRational, 8, kMatcher_px).frame_px, "px", 0.1);
    tell("self_fisheye_frame_error", noisySeries(kFisheye, 8, kMatcher_px).frame_px, "px", 0.1);
    tell("self_thesis_lens_frame_error", noisySeries(kThesis, 8, kMatcher_px).frame_px, "px", 0.1);
    contained("drawn", drawnSeries(kBrown, 3));
    bent("drawn_rational", drawnSeries(kRational, 3));
    bent("drawn_fisheye", drawnSeries(kFisheye, 3));
}

}  // namespace pmts::bench
