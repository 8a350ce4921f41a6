#include "determinable.hpp"

#include "rig_parameters.hpp"

#include <Eigen/SVD>
#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::calibration {
namespace {

using enum RigParameter;

QString text(const char* sentence) { return QCoreApplication::translate("Calibration", sentence); }

/// Held first comes first. Offsets are not among them: whether they can be found is a matter of the ranges.
constexpr std::array kHoldOrder{kP1,      kP2,    kK3,      kK2,      kYaw,     kPitch, kCentreX,
                                kCentreY, kTwist, kOffsetY, kOffsetX, kOffsetZ, kK1,    kFocalLength};

/// What a picture is worth at best and usually. A model that fits badly makes nothing less determinable.
constexpr double kUsualMatch_px = 0.05;

/// Less certain than this it had better keep what was known before.
double weakestUseful(RigParameter parameter, const camera::Rig& rig) {
    switch (parameter) {
        case kFocalLength:
            return 0.003 * rig.lens.focalLengthPx();
        case kCentreX:
        case kCentreY:
            return 4.0;  // px
        case kYaw:
        case kPitch:
        case kTwist:
            return core::Angle::fromGon(0.02).rad();
        case kOffsetX:
        case kOffsetY:
        case kOffsetZ:
            return 0.005;  // m
        default:
            return 1.0;  // a distortion nobody needs harms nobody inside the swept picture
    }
}

QString remedyFor(const SweepState& state, bool with_direction) {
    if (state.rig.mount.kind == camera::MountKind::kHandle) {
        return with_direction ? text("put the cross-hair of the telescope on the spot before the sweep")
                              : text("add spots higher up and lower down, each sighted with the telescope");
    }
    return with_direction ? text("sweep in both faces")
                          : text("choose a spot that can be swept over the whole picture");
}

struct Partners {
    std::vector<RigParameter> rig;
    bool direction = false;
};

Partners partnersIn(const SweepFit& fit, const Eigen::VectorXd& weakest) {
    const double enough = 0.25 * weakest.cwiseAbs().maxCoeff();
    Partners partners;
    const auto rig_count = static_cast<Eigen::Index>(fit.unknowns.rig.size());
    for (Eigen::Index i = 0; i < weakest.size(); ++i) {
        if (std::abs(weakest(i)) < enough) {
            continue;
        }
        if (i < rig_count) {
            partners.rig.push_back(fit.unknowns.rig[static_cast<std::size_t>(i)]);
        } else {
            partners.direction = true;
        }
    }
    return partners;
}

QString sentenceFor(RigParameter held, const Partners& partners, const SweepState& state) {
    QStringList others;
    for (const RigParameter parameter : partners.rig) {
        if (parameter != held) {
            others.append(parameterWords(parameter));
        }
    }
    if (partners.direction) {
        others.append(text("the direction of the spot"));
    }
    const QString remedy = remedyFor(state, partners.direction);
    if (others.isEmpty()) {
        return text("The %1 cannot be found from these pictures: %2.").arg(parameterWords(held), remedy);
    }
    return text("The %1 cannot be told apart from %2: %3.")
        .arg(parameterWords(held), others.join(text(" and ")), remedy);
}

std::optional<RigParameter> toHold(const SweepFit& fit, const SweepPrecision& precision) {
    bool weak = false;
    for (std::size_t i = 0; i < precision.deviations.size(); ++i) {
        const auto& deviation = precision.deviations[i];
        const double useful =
            i < fit.unknowns.rig.size() ? weakestUseful(fit.unknowns.rig[i], fit.state.rig) : 0.01;
        weak = weak || !deviation || *deviation * kUsualMatch_px / fit.precisionSigma_px() > useful;
    }
    if (!weak) {
        return std::nullopt;
    }
    const Partners partners = partnersIn(fit, precision.weakest);
    for (const RigParameter parameter : kHoldOrder) {
        if (std::find(partners.rig.begin(), partners.rig.end(), parameter) != partners.rig.end()) {
            return parameter;
        }
    }
    return std::nullopt;
}

/// Offsets show as the difference of two ranges; at one they look like rotations and scale, and what the lens
/// model leaves over would go into them.
bool rangesTellOffsets(const std::vector<SweptSpot>& spots) {
    constexpr double kApart = 1.5;
    double nearest_m = spots.front().about.slope_distance_m;
    double furthest_m = nearest_m;
    for (const SweptSpot& spot : spots) {
        nearest_m = std::min(nearest_m, spot.about.slope_distance_m);
        furthest_m = std::max(furthest_m, spot.about.slope_distance_m);
    }
    return std::all_of(spots.begin(), spots.end(),
                       [](const SweptSpot& spot) { return spot.range_measured; }) &&
           furthest_m >= kApart * nearest_m;
}

std::vector<HeldParameter> holdOffsetsAtOneRange(const SweepState& state, SweepUnknowns& unknowns) {
    if (rangesTellOffsets(state.spots)) {
        return {};
    }
    const std::pair<RigParameter, RigParameter> kAlike[] = {
        {kOffsetX, kYaw}, {kOffsetY, kFocalLength}, {kOffsetZ, kPitch}};
    std::vector<HeldParameter> held;
    QStringList pairs;
    for (const auto& [offset, alike] : kAlike) {
        if (std::erase(unknowns.rig, offset) > 0) {
            held.push_back({offset, {}});
            pairs.append(text("the %1 from the %2").arg(parameterWords(offset), parameterWords(alike)));
        }
    }
    for (HeldParameter& one : held) {
        one.sentence = text("One range cannot tell %1: sweep a second spot at half the range or less and "
                            "measure both distances.")
                           .arg(pairs.join(text(", ")));
    }
    return held;
}

}  // namespace

SweepPrecision precisionOf(const SweepFit& fit) {
    constexpr double kUnseen =
        1e-6;  // of the largest singular value; numeric derivatives are good to about 1e-8
    constexpr double kMoves = 0.01;
    const Eigen::VectorXd scale = fit.jacobian.colwise().norm().transpose().cwiseMax(1e-300);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(fit.jacobian * scale.cwiseInverse().asDiagonal(),
                                                Eigen::ComputeThinV);
    const Eigen::VectorXd& seen = svd.singularValues();
    const Eigen::Index n = scale.size();
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
    SweepPrecision precision;
    precision.deviations.assign(static_cast<std::size_t>(n), 0.0);
    for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::VectorXd part = svd.matrixV().col(k);
        if (seen(k) > kUnseen * seen(0)) {
            covariance += part * part.transpose() / (seen(k) * seen(k));
            continue;
        }
        for (Eigen::Index i = 0; i < n; ++i) {
            if (std::abs(part(i)) > kMoves) {
                precision.deviations[static_cast<std::size_t>(i)].reset();
            }
        }
    }
    precision.weakest = svd.matrixV().col(n - 1);
    const Eigen::VectorXd root = covariance.diagonal().cwiseMax(1e-300).cwiseSqrt();
    precision.correlation = root.cwiseInverse().asDiagonal() * covariance * root.cwiseInverse().asDiagonal();
    for (Eigen::Index i = 0; i < n; ++i) {
        if (auto& deviation = precision.deviations[static_cast<std::size_t>(i)]) {
            deviation = fit.precisionSigma_px() * root(i) / scale(i);
        }
    }
    return precision;
}

core::Result<DeterminedFit> fitDeterminable(const SweepState& start, SweepUnknowns unknowns) {
    std::vector<HeldParameter> held = holdOffsetsAtOneRange(start, unknowns);
    while (true) {
        auto fit = fitSweepRobustly(start, unknowns);
        PMTS_TRY(fit);
        SweepPrecision precision = precisionOf(*fit);
        const auto next = toHold(*fit, precision);
        if (!next || unknowns.rig.size() <= 2) {
            return DeterminedFit{std::move(*fit), std::move(precision), std::move(held)};
        }
        held.push_back({*next, sentenceFor(*next, partnersIn(*fit, precision.weakest), fit->state)});
        std::erase(unknowns.rig, *next);
    }
}

}  // namespace pmts::calibration
