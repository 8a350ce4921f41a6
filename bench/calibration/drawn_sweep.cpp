#include "drawn_sweep.hpp"

#include "pmts/calibration/sweep_plan.hpp"
#include "pmts/geometry/polar.hpp"
#include "support/run_to_end.hpp"
#include "targeting/pictures.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace pmts::bench {
namespace {

using core::Angle;
using geometry::Pointing;

/// A wall across HA 0, and a nearer one across HA 200.
simulator::Panel wall(double north_m, double metres_a_texel, unsigned seed) {
    const double half_m = std::abs(north_m) * 0.9;
    const double right = north_m > 0 ? 1 : -1;
    const cv::Size size(static_cast<int>(2 * half_m / metres_a_texel),
                        static_cast<int>(half_m / metres_a_texel));
    return {QStringLiteral("wall"),
            {-right * half_m, north_m, -0.5 * half_m},
            {2 * right * half_m, 0, 0},
            {0, 0, half_m},
            test::naturalTexture(size, seed)};
}

}  // namespace

DrawnSweeps::DrawnSweeps(const camera::Rig& truth, unsigned seed)
    : truth_(truth), station_(clock_, pointing_, {.servo_cc = 4.0, .reading_cc = 3.0, .seed = seed}) {
    const auto scene = std::make_shared<const simulator::Scene>(
        std::vector{wall(22, 0.010, seed + 50), wall(-5, 0.0023, seed + 60)});
    frames_ = std::make_unique<test::SceneFrames>(
        clock_, std::make_shared<simulator::SceneCamera>(
                    scene, pointing_, truth,
                    simulator::CameraFaults{.noise_sigma = 2.0, .blur_px = 0.6, .seed = seed}));
}

double DrawnSweeps::matcherRms_px() const {
    return pictures_ > 0 ? std::sqrt(sum2_px_ / (2.0 * static_cast<double>(pictures_))) : 0.0;
}

std::optional<DrawnSweeps::Spot> DrawnSweeps::clicked(double range_m) {
    const double ha_gon = range_m > 10 ? 1.5 : 201.5;
    pointing_->place({Angle::fromGon(ha_gon), Angle::fromGon(99)});
    const double wall_m = range_m > 10 ? 22 : -5;
    const targeting::PixelToPointing model(truth_);
    const Eigen::Vector2d middle(0.5 * truth_.width_px, 0.5 * truth_.height_px);
    for (int i = 0; i < 40; ++i) {  // a spot that can be found again
        const Eigen::Vector2d px = middle + Eigen::Vector2d(9.0 * (i % 7) - 25, 11.0 * i / 7.0 - 25);
        const camera::FramePtr frame = frames_->now();
        if (!targeting::PatchMatcher().take(frame->image, px)) {
            continue;
        }
        const auto ray = model.rayForPixel(px, pointing_->at(clock_.now()));
        const Eigen::Vector3d p_station = ray->at((wall_m - ray->origin_m.y()) / ray->direction.y());
        const Pointing at = station_.reading();
        return Spot{
            at, p_station, {.frame = frame, .at = at, .px = px, .slope_distance_m = p_station.norm()}};
    }
    return std::nullopt;
}

bool DrawnSweeps::sweep(const Spot& spot, const camera::Rig& rig, const std::vector<Pointing>& pointings,
                        double radius_px, calibration::SweptSpot& swept) {
    targeting::SpotSweep routine(station_, frames_->source(), targeting::findHere(targeting::PatchMatcher()),
                                 targeting::PixelToPointing(rig), clock_, {.search_radius_px = radius_px});
    routine.seen_before = seen_;
    routine.on_step = [&](const targeting::SweepStep& step) {
        if (step.sighting) {
            const auto true_px =
                targeting::PixelToPointing(truth_).pixelForPoint(spot.p_station, pointing_->at(clock_.now()));
            sum2_px_ += true_px ? (*true_px - step.sighting->px).squaredNorm() : 0.0;
            ++pictures_;
        }
    };
    const auto ended = test::runToEnd(routine.run(spot.click, pointings, {}), clock_, std::chrono::hours(1));
    if (!ended || !*ended) {
        std::printf("# sweep ended: %s\n", ended ? qPrintable(ended->error().sentence()) : "never");
        return false;
    }
    missed_ += static_cast<int>((*ended)->missed.size());
    for (const targeting::MissedPointing& missed : (*ended)->missed) {
        std::printf("# missed %zu of %zu: %s\n", missed.index, pointings.size(), qPrintable(missed.reason.detail));
    }
    seen_.insert(seen_.end(), (*ended)->sightings.begin(), (*ended)->sightings.end());
    for (const targeting::SpotSighting& sighting : (*ended)->sightings) {
        swept.pictures.push_back({sighting.at, sighting.px});
    }
    return true;
}

std::vector<calibration::SweptSpot> DrawnSweeps::run(const camera::Rig& start,
                                                     const std::vector<double>& ranges_m,
                                                     const std::vector<int>& pointings) {
    std::vector<calibration::SweptSpot> swept;
    camera::Rig rig = start;
    for (std::size_t i = 0; i < ranges_m.size(); ++i) {
        const auto spot = clicked(ranges_m[i]);
        if (!spot) {
            return swept;
        }
        const double range_m = spot->p_station.norm();
        const auto believedPlace = [&] {
            const auto ray =
                targeting::PixelToPointing(rig).pointingForPixel(spot->click.px, spot->at, range_m);
            return geometry::PolarPoint{*ray, range_m};
        };
        calibration::SweptSpot one{
            .about = believedPlace(), .range_measured = true, .direction_sighted = false, .pictures = {}};
        int left = pointings[i];
        seen_.clear();
        for (int stage = i == 0 ? 0 : calibration::kScoutingStages; stage <= calibration::kScoutingStages;
             ++stage) {
            const bool scouts = stage < calibration::kScoutingStages;
            const auto options = scouts ? calibration::scouting(stage)
                                        : calibration::SweepPlanOptions{.most_pointings = left};
            const auto plan =
                calibration::planSweep(rig, geometry::stationFromPolar(believedPlace()), options);
            if (!plan || !sweep(*spot, rig, plan->pointings, scouts ? 60 : 30, one)) {
                return swept;
            }
            left -= static_cast<int>(plan->pointings.size());
            rig = i == 0 ? calibration::roughRig({one}, start).value_or(rig) : rig;
        }
        swept.push_back(std::move(one));
        if (const auto solved = calibration::selfCalibrate(swept, {.start = start})) {
            rig = solved->rig;
        }
    }
    return swept;
}

}  // namespace pmts::bench
