#include "clicks.hpp"

#include "pmts/core/virtual_clock.hpp"
#include "pmts/geometry/frames.hpp"
#include "pmts/geometry/polar.hpp"
#include "pmts/targeting/recentring.hpp"
#include "support/fake_total_station.hpp"
#include "support/run_to_end.hpp"
#include "support/scene_frames.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <chrono>
#include <cmath>
#include <random>

namespace pmts::bench {
namespace {

using core::Angle;
using geometry::Pointing;

/// The first surface along any half line; panels only.
std::optional<Eigen::Vector3d> surfaceAlong(const simulator::Scene& scene, const geometry::Ray& ray) {
    std::optional<double> nearest_m;
    for (const simulator::Panel& panel : scene.panels()) {
        Eigen::Matrix3d axes;
        axes << panel.right_m, panel.up_m, -ray.direction;
        const Eigen::Vector3d hit = axes.fullPivLu().solve(ray.origin_m - panel.origin_m);
        const bool on = hit.x() >= 0 && hit.x() <= 1 && hit.y() >= 0 && hit.y() <= 1 && hit.z() > 0.1;
        if (on && (!nearest_m || hit.z() < *nearest_m)) {
            nearest_m = hit.z();
        }
    }
    return nearest_m ? std::optional<Eigen::Vector3d>(ray.at(*nearest_m)) : std::nullopt;
}

core::Task<core::Result<targeting::Match>> answered(core::Result<targeting::Match> match) { co_return match; }

/// Simulated instrument, camera and clock of one series.
class Bench {
public:
    explicit Bench(const ClickSeries& series)
        : series_(series),
          random_(series.seed),
          truth_(std::make_shared<simulator::TruePointing>()),
          station_(clock_, truth_, {.servo_cc = 4.0, .reading_cc = 1.0, .seed = series.seed}),
          true_model_(series.true_rig),
          believed_model_(series.believed_rig) {
        for (const double blur_px : {0.0, 0.6, 1.0}) {
            cameras_.push_back(std::make_shared<simulator::SceneCamera>(
                series.scene, truth_, series.true_rig,
                simulator::CameraFaults{.noise_sigma = 2.5, .blur_px = blur_px, .seed = series.seed}));
        }
    }

    void click(ClickOutcome& outcome) {
        truth_->place({core::normalized(Angle::fromGon(uniform(-series_.most_ha_gon, series_.most_ha_gon))),
                       Angle::fromGon(100 + uniform(-series_.most_tilt_gon, series_.most_tilt_gon))});
        const Pointing true_at = truth_->at(clock_.now());
        const Eigen::Vector2d px(uniform(20, series_.true_rig.width_px - 21),
                                 uniform(20, series_.true_rig.height_px - 21));
        const auto spot = surfaceAlong(*series_.scene, true_model_.rayForPixel(px, true_at).value());
        if (!spot) {
            return;  // the sky is no target
        }
        test::SceneFrames before(clock_, cameras_[pick(cameras_.size())]);
        targeting::Click click{
            .frame = before.now(), .at = station_.reading(), .px = px, .slope_distance_m = spot->norm(),
            .first_target = {}};
        test::SceneFrames after(clock_, cameras_[pick(cameras_.size())]);
        const double gain = 1.0 + uniform(-series_.exposure_drift, series_.exposure_drift);
        after.change = [gain](cv::Mat& picture) { picture.convertTo(picture, -1, gain); };
        follow(click, *spot, after, outcome);
    }

private:
    void follow(const targeting::Click& click, const Eigen::Vector3d& spot, test::SceneFrames& frames,
                ClickOutcome& outcome) {
        targeting::FindPatch timed = targeting::findHere(targeting::PatchMatcher());
        timed.find = [&outcome](const targeting::Patch& patch, const camera::FramePtr& frame,
                                const targeting::Expectation& expected) {
            const auto start = std::chrono::steady_clock::now();
            auto match = targeting::PatchMatcher().find(patch, frame->image, expected);
            outcome.step_ms.push_back(
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
            return answered(std::move(match));
        };
        const auto frame_source = frames.source();
        targeting::Recentring recentring(station_, frame_source, timed, believed_model_, clock_);
        recentring.on_step = [&](const targeting::RecentringStep& step) {
            if (step.matched && step.move == 1) {
                open_loop2_ += std::pow(trueOff(spot, true_model_).norm(), 2);
                ++open_loops_;
            }
        };
        const int turns_before = station_.turns;
        const auto ended = test::runToEnd(recentring.turnTo(click, {}), clock_, std::chrono::seconds(600));
        if (!ended) {
            ++outcome.failures["never ended"];
        } else if (!*ended && station_.turns == turns_before) {
            ++outcome.refused;
            ++outcome.failures["at the click: " + ended->error().detail.section(' ', 0, 0).toStdString()];
        } else {
            ++outcome.clicks;
            *ended ? settled(**ended, spot, outcome) : failed(ended->error(), outcome);
        }
        outcome.open_loop_rms_px = open_loops_ ? std::sqrt(open_loop2_ / open_loops_) : 0.0;
    }

    void settled(const targeting::Recentred& at, const Eigen::Vector3d& spot, ClickOutcome& outcome) {
        ++outcome.settled;
        outcome.settled_in_two += at.moves <= 2;
        outcome.settled_in_three += at.moves <= 3;
        const double off_px = trueOff(spot, believed_model_).norm();
        const Eigen::Vector3d axis = geometry::directionFromPointing(truth_->at(clock_.now()));
        const double off_arcsec =
            Angle::fromRad(std::atan2(axis.cross(spot).norm(), axis.dot(spot))).arcsec();
        outcome.wrong += off_px > 1.0;
        outcome.largest_px = std::max(outcome.largest_px, off_px);
        sum2_px_ += off_px * off_px;
        sum2_arcsec_ += off_arcsec * off_arcsec;
        outcome.rms_px = std::sqrt(sum2_px_ / outcome.settled);
        outcome.rms_arcsec = std::sqrt(sum2_arcsec_ / outcome.settled);
    }

    static void failed(const core::Error& error, ClickOutcome& outcome) {
        ++outcome.failures[error.detail.section(' ', 0, 0).toStdString()];
    }

    /// The spot as the camera truly sees it, against the reticle of a model.
    [[nodiscard]] Eigen::Vector2d trueOff(const Eigen::Vector3d& spot,
                                          const targeting::PixelToPointing& reticle_of) const {
        const Pointing at = truth_->at(clock_.now());
        return true_model_.pixelForPoint(spot, at).value() - reticle_of.reticlePixel(at, spot.norm()).value();
    }

    double uniform(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random_);
    }
    std::size_t pick(std::size_t of) {
        return std::uniform_int_distribution<std::size_t>(0, of - 1)(random_);
    }

    const ClickSeries& series_;
    std::mt19937 random_;
    core::VirtualClock clock_;
    std::shared_ptr<simulator::TruePointing> truth_;
    test::FakeTotalStation station_;
    targeting::PixelToPointing true_model_, believed_model_;
    std::vector<std::shared_ptr<simulator::SceneCamera>> cameras_;
    double sum2_px_ = 0, sum2_arcsec_ = 0, open_loop2_ = 0;
    int open_loops_ = 0;
};

}  // namespace

ClickOutcome runClicks(const ClickSeries& series) {
    ClickOutcome outcome;
    Bench bench(series);
    while (outcome.clicks + (series.count_refused ? outcome.refused : 0) < series.clicks) {
        bench.click(outcome);
    }
    return outcome;
}

}  // namespace pmts::bench
