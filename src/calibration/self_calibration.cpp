#include "pmts/calibration/self_calibration.hpp"

#include "determinable.hpp"
#include "held_out.hpp"
#include "outward_lens.hpp"
#include "residual_table_fit.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pmts::calibration {
namespace {

using enum RigParameter;

QString text(const char* sentence) { return QCoreApplication::translate("Calibration", sentence); }

constexpr std::size_t kLeastPictures = 8;
constexpr double kAsGood = 1.04;  // chance alone changes held-out residuals of 60 pictures by that much

core::Result<void> usable(const std::vector<SweptSpot>& spots, const camera::Rig& start) {
    const std::size_t pictures =
        std::accumulate(spots.begin(), spots.end(), std::size_t{0},
                        [](std::size_t sum, const SweptSpot& spot) { return sum + spot.pictures.size(); });
    if (pictures < kLeastPictures) {
        return core::fail(
            core::ErrorKind::kBadInput, text("There are too few pictures for a calibration."),
            text("Sweep a sharp spot over the whole picture: at least %1 are needed.").arg(kLeastPictures));
    }
    if (!std::holds_alternative<camera::BrownLens>(start.lens.model())) {
        return core::fail(core::ErrorKind::kBadInput,
                          text("A calibration starts from a lens with a focal length."),
                          text("Start from the camera's data sheet."));
    }
    return {};
}

/// The start without a table, and without the distortions that this trial leaves out.
SweepState startOf(const std::vector<SweptSpot>& spots, const camera::Rig& start,
                   const std::vector<RigParameter>& distortion) {
    auto lens = std::get<camera::BrownLens>(start.lens.model());
    const auto keep = [&](RigParameter parameter, double& value) {
        if (std::find(distortion.begin(), distortion.end(), parameter) == distortion.end()) {
            value = 0;
        }
    };
    keep(kK1, lens.k1);
    keep(kK2, lens.k2);
    keep(kK3, lens.k3);
    keep(kP1, lens.p1);
    keep(kP2, lens.p2);
    SweepState state{start, spots};
    state.rig.lens = camera::Lens(lens);
    return state;
}

SweepUnknowns unknownsOf(const std::vector<SweptSpot>& spots, const std::vector<RigParameter>& distortion) {
    SweepUnknowns unknowns{
        .rig = {kFocalLength, kCentreX, kCentreY, kYaw, kPitch, kTwist, kOffsetX, kOffsetY, kOffsetZ},
        .directions = {}};
    unknowns.rig.insert(unknowns.rig.begin() + 3, distortion.begin(), distortion.end());
    for (std::size_t i = 0; i < spots.size(); ++i) {
        if (!spots[i].direction_sighted) {
            unknowns.directions.push_back(i);
        }
    }
    return unknowns;
}

struct Trial {
    DistortionTrial trial;
    DeterminedFit determined;
    std::vector<SweepFit> left_out;
};

core::Result<Trial> tried(const std::vector<SweptSpot>& spots, const SelfCalibrationOptions& options,
                          const std::vector<RigParameter>& distortion) {
    auto determined =
        fitDeterminable(startOf(spots, options.start, distortion), unknownsOf(spots, distortion));
    PMTS_TRY(determined);
    auto left_out = fitWithoutParts(determined->fit, options.folds);
    PMTS_TRY(left_out);
    const double held_out_px =
        rmsOf(heldOutResiduals(determined->fit, *left_out), usedPictures(determined->fit));
    return Trial{{distortion, held_out_px}, std::move(*determined), std::move(*left_out)};
}

/// The simplest that is not really worse than the best.
std::size_t chosen(const std::vector<Trial>& trials) {
    const auto less = [](const Trial& a, const Trial& b) {
        return a.trial.held_out_px < b.trial.held_out_px;
    };
    const double best = std::min_element(trials.begin(), trials.end(), less)->trial.held_out_px;
    std::size_t index = 0;
    while (trials[index].trial.held_out_px > kAsGood * best) {
        ++index;
    }
    return index;
}

SelfCalibration reported(const Trial& best) {
    const SweepFit& fit = best.determined.fit;
    SelfCalibration result;
    result.rig = fit.state.rig;
    for (const SweptSpot& spot : fit.state.spots) {
        result.spots.push_back(spot.about);
    }
    const Eigen::VectorXd values = valuesOf(fit.state, fit.unknowns);
    for (std::size_t i = 0; i < fit.unknowns.rig.size(); ++i) {
        result.parameters.push_back({fit.unknowns.rig[i], values(static_cast<Eigen::Index>(i)),
                                     best.determined.precision.deviations[i]});
    }
    const auto count = static_cast<Eigen::Index>(fit.unknowns.rig.size());
    result.correlation = best.determined.precision.correlation.topLeftCorner(count, count);
    result.held = best.determined.held;
    for (std::size_t i = 0; i < fit.weights.size(); ++i) {
        result.residuals_px.emplace_back(fit.residuals_px.segment<2>(static_cast<Eigen::Index>(2 * i)));
        if (fit.weights[i] <= 0) {
            result.outliers.push_back(i);
        }
    }
    result.rms_px = fit.rms_px();
    result.held_out_px = result.held_out_without_table_px = best.trial.held_out_px;
    return result;
}

std::vector<TableStiffness> tableChoices() {
    std::vector<TableStiffness> choices;
    for (const std::optional<double> radial : {std::optional<double>(), {0.01}, {0.1}, {1.0}, {10.0}}) {
        for (const std::optional<double> plane : {std::optional<double>(), {0.01}, {0.1}, {1.0}, {10.0}}) {
            if (radial || plane) {
                choices.push_back({radial, plane});
            }
        }
    }
    return choices;
}

/// Puts the table on top where pictures that it never saw say that it helps.
void addTable(SelfCalibration& result, const Trial& best, const SelfCalibrationOptions& options) {
    const SweepFit& fit = best.determined.fit;
    const std::vector<bool> used = usedPictures(fit);
    double best_px = best.trial.held_out_px * options.table_gain;
    std::optional<camera::ResidualTable> table;
    for (const TableStiffness& stiffness : tableChoices()) {
        const double held_out_px = rmsOf(heldOutWithTable(fit, best.left_out, stiffness), used);
        auto candidate = held_out_px < best_px
                             ? surfaceOver(fit, stiffness).table(result.rig.width_px, result.rig.height_px)
                             : std::nullopt;
        if (candidate) {
            best_px = held_out_px;
            table = std::move(candidate);
        }
    }
    if (!table) {
        return;
    }
    result.held_out_px = best_px;
    result.rig.lens = result.rig.lens.withResiduals(std::move(table));
    const SweepState with_table{result.rig, fit.state.spots};
    if (const auto residuals = sweepResiduals(with_table, fit.weights)) {
        for (std::size_t i = 0; i < result.residuals_px.size(); ++i) {
            result.residuals_px[i] = residuals->segment<2>(static_cast<Eigen::Index>(2 * i));
        }
        result.rms_px = rmsOf(*residuals, used);
    }
}

/// How far from the middle the pictures reach, as a share of half the diagonal.
double reachOf(const std::vector<SweptSpot>& spots, const camera::Rig& rig) {
    const Eigen::Vector2d half(0.5 * rig.width_px, 0.5 * rig.height_px);
    double furthest = 0;
    for (const SweptSpot& spot : spots) {
        for (const SpotPicture& picture : spot.pictures) {
            furthest = std::max(furthest, (picture.px - half).norm() / half.norm());
        }
    }
    return furthest;
}

/// A second distortion shows only away from the centre. A third would follow what was seen more closely and
/// leave it the sooner further out.
std::vector<RigParameter> roughDistortion(double reach) {
    return reach > 0.45 ? std::vector{kK1, kK2} : std::vector{kK1};
}

}  // namespace

core::Result<camera::Rig> roughRig(const std::vector<SweptSpot>& spots, const camera::Rig& start) {
    PMTS_TRY(usable(spots, start));
    const double reach = reachOf(spots, start);
    const auto distortion = roughDistortion(reach);
    const bool centre_shows = reach > 0.75 && start.mount.kind != camera::MountKind::kHandle;
    SweepUnknowns unknowns = unknownsOf(spots, distortion);
    std::erase_if(unknowns.rig, [centre_shows](RigParameter parameter) {
        const bool centre = parameter == kCentreX || parameter == kCentreY;
        return (centre && !centre_shows) || parameter >= kOffsetX;
    });
    if (start.mount.kind == camera::MountKind::kHandle) {
        std::erase_if(unknowns.rig,
                      [](RigParameter parameter) { return parameter == kYaw || parameter == kPitch; });
    }
    auto fit = fitSweepRobustly(startOf(spots, start, distortion), unknowns);
    PMTS_TRY(fit);
    camera::Rig rig = fit->state.rig;
    const double seen_px = 0.5 * reach * std::hypot(rig.width_px, rig.height_px);
    const auto ray = rig.lens.cameraFromPixel(rig.lens.principalPoint() + Eigen::Vector2d(seen_px, 0));
    if (ray && ray->z() > 0) {
        rig.lens = continuedOutward(rig.lens, ray->x() / ray->z());
    }
    return rig;
}

core::Result<SelfCalibration> selfCalibrate(const std::vector<SweptSpot>& spots,
                                            const SelfCalibrationOptions& options,
                                            const std::function<bool(double done)>& go_on) {
    PMTS_TRY(usable(spots, options.start));
    std::vector<Trial> trials;
    std::optional<core::Error> failure;
    for (std::size_t i = 0; i < options.distortions.size(); ++i) {
        if (go_on && !go_on(static_cast<double>(i) / static_cast<double>(options.distortions.size()))) {
            return core::cancelled();
        }
        auto trial = tried(spots, options, options.distortions[i]);
        if (trial) {
            trials.push_back(std::move(*trial));
        } else {
            failure = trial.error();
        }
    }
    if (trials.empty()) {
        return tl::unexpected(failure.value());
    }
    const Trial& best = trials[chosen(trials)];
    SelfCalibration result = reported(best);
    for (const Trial& trial : trials) {
        result.trials.push_back(trial.trial);
    }
    if (options.residual_table) {
        addTable(result, best, options);
    }
    return result;
}

}  // namespace pmts::calibration
