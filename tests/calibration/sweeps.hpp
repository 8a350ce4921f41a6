#pragma once

#include "pmts/calibration/self_calibration.hpp"
#include "pmts/calibration/sweep_plan.hpp"

#include <random>

namespace pmts::test {

/// How wrongly a simulated sweep sees: one sigma each.
struct SweepNoise {
    double px = 0.02;
    double circles_cc = 3.0;
    double range_m = 0.003;
    unsigned seed = 1;
};

/// What somebody knows of a camera just strapped on: f 4 % off, no rotations, offsets by a ruler.
inline camera::Rig dataSheetRig(const camera::Rig& truth) {
    camera::Rig rig = truth;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 0.96 * truth.lens.focalLengthPx(),
                                              .cx_px = 0.5 * (truth.width_px - 1),
                                              .cy_px = 0.5 * (truth.height_px - 1)});
    rig.mount = {.kind = truth.mount.kind, .offset_m = {0.0, 0.10, 0.06}};
    return rig;
}

/// A sweep over the whole picture as the true camera would see it, planned with what is believed of it.
inline calibration::SweptSpot sweepOf(const camera::Rig& truth, const camera::Rig& believed,
                                      const geometry::PolarPoint& spot, const SweepNoise& noise,
                                      const calibration::SweepPlanOptions& options = {}) {
    std::mt19937 engine(noise.seed);
    std::normal_distribution<double> one(0.0, 1.0);
    const Eigen::Vector3d p_station = geometry::stationFromPolar(spot);
    const auto plan = calibration::planSweep(believed, p_station, options).value();
    calibration::SweptSpot swept{
        .about = spot, .range_measured = true, .direction_sighted = false, .pictures = {}};
    swept.about.pointing.ha += core::Angle::fromGon(0.5);
    swept.about.slope_distance_m += noise.range_m * one(engine);
    for (const geometry::Pointing& at : plan.pointings) {
        const auto px = camera::pixelFromStation(truth, at, p_station);
        if (!px || px->x() < 15 || px->y() < 15 || px->x() > truth.width_px - 16 ||
            px->y() > truth.height_px - 16) {
            continue;
        }
        const auto read = [&](core::Angle circle) {
            return circle + core::Angle::fromCc(noise.circles_cc * one(engine));
        };
        const Eigen::Vector2d off_px(noise.px * one(engine), noise.px * one(engine));
        swept.pictures.push_back({{read(at.ha), read(at.va)}, *px + off_px});
    }
    return swept;
}

/// Two scouting sweeps, what they tell, and the rest of the 60 pointings planned with that: as the program
/// does it.
inline calibration::SweptSpot scoutedSweepOf(const camera::Rig& truth, const camera::Rig& believed,
                                             const geometry::PolarPoint& spot, SweepNoise noise,
                                             int pointings = 60) {
    calibration::SweptSpot swept;
    camera::Rig rig = believed;
    for (int stage = 0; stage <= calibration::kScoutingStages; ++stage) {
        const int left = pointings - static_cast<int>(swept.pictures.size());
        const bool last = stage == calibration::kScoutingStages;
        const auto options =
            last ? calibration::SweepPlanOptions{.most_pointings = left} : calibration::scouting(stage);
        calibration::SweptSpot more = sweepOf(truth, rig, spot, noise, options);
        more.pictures.insert(more.pictures.begin(), swept.pictures.begin(), swept.pictures.end());
        swept = std::move(more);
        rig = calibration::roughRig({swept}, believed).value_or(rig);
        noise.seed += 5000;
    }
    return swept;
}

inline geometry::PolarPoint spotAt(double ha_gon, double va_gon, double range_m) {
    return {{core::Angle::fromGon(ha_gon), core::Angle::fromGon(va_gon)}, range_m};
}

/// Calibrated against true camera over a fine grid of the picture, as a click would feel it: where each puts
/// what stands 12 m away in the frame of the carrier. Root mean square over the coordinates, px.
inline double frameError_px(const camera::Rig& truth, const camera::Rig& calibrated, double range_m = 12.0) {
    const geometry::Pointing at{core::Angle::fromGon(0), core::Angle::fromGon(100)};
    const camera::CameraPose pose = camera::cameraPose(truth.mount, at);
    double sum2 = 0;
    int count = 0;
    for (double v = 8; v < truth.height_px - 8; v += 16) {
        for (double u = 8; u < truth.width_px - 8; u += 16) {
            const Eigen::Vector3d p_station =
                pose.centre_station_m +
                range_m * (pose.station_from_camera * *truth.lens.cameraFromPixel({u, v}));
            const auto px = camera::pixelFromStation(calibrated, at, p_station);
            sum2 += px ? (*px - Eigen::Vector2d(u, v)).squaredNorm() : 1e4;
            count += 2;
        }
    }
    return std::sqrt(sum2 / count);
}

}  // namespace pmts::test
