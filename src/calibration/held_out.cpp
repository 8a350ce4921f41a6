#include "held_out.hpp"

namespace pmts::calibration {
namespace {

std::size_t partOf(std::size_t picture, std::size_t parts) { return picture % parts; }

std::vector<Eigen::Vector2d> seenPixels(const SweepFit& fit) {
    std::vector<Eigen::Vector2d> seen;
    for (const SweptSpot& spot : fit.state.spots) {
        for (const SpotPicture& picture : spot.pictures) {
            seen.push_back(picture.px);
        }
    }
    return seen;
}

}  // namespace

std::vector<bool> usedPictures(const SweepFit& fit) {
    std::vector<bool> used;
    for (const double weight : fit.weights) {
        used.push_back(weight > 0);
    }
    return used;
}

core::Result<std::vector<SweepFit>> fitWithoutParts(const SweepFit& fit, int parts) {
    std::vector<SweepFit> fits;
    for (int part = 0; part < parts; ++part) {
        std::vector<double> weights = fit.weights;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            if (partOf(i, static_cast<std::size_t>(parts)) == static_cast<std::size_t>(part)) {
                weights[i] = 0;
            }
        }
        auto without = fitSweep(fit.state, fit.unknowns, weights);
        PMTS_TRY(without);
        fits.push_back(std::move(*without));
    }
    return fits;
}

Eigen::VectorXd heldOutResiduals(const SweepFit& fit, const std::vector<SweepFit>& left_out) {
    Eigen::VectorXd held_out = fit.residuals_px;
    for (std::size_t i = 0; i < fit.weights.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(2 * i);
        held_out.segment<2>(at) = left_out[partOf(i, left_out.size())].residuals_px.segment<2>(at);
    }
    return held_out;
}

ResidualSurface surfaceOver(const SweepFit& fit, const TableStiffness& stiffness) {
    const camera::Rig& rig = fit.state.rig;
    return {leftOver(fit, usedPictures(fit)), rig.lens.principalPoint(), rig.width_px, rig.height_px,
            stiffness};
}

Eigen::VectorXd heldOutWithTable(const SweepFit& fit, const std::vector<SweepFit>& left_out,
                                 const TableStiffness& stiffness) {
    Eigen::VectorXd held_out = heldOutResiduals(fit, left_out);
    const std::vector<Eigen::Vector2d> seen = seenPixels(fit);
    std::vector<ResidualSurface> surfaces;
    for (const SweepFit& without : left_out) {
        surfaces.push_back(surfaceOver(without, stiffness));
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
        held_out.segment<2>(static_cast<Eigen::Index>(2 * i)) +=
            surfaces[partOf(i, left_out.size())].at(seen[i]);
    }
    return held_out;
}

std::vector<LeftOver> leftOver(const SweepFit& fit, const std::vector<bool>& pictures) {
    const std::vector<Eigen::Vector2d> seen = seenPixels(fit);
    std::vector<LeftOver> left_over;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (pictures[i]) {
            left_over.push_back({seen[i], -fit.residuals_px.segment<2>(static_cast<Eigen::Index>(2 * i))});
        }
    }
    return left_over;
}

}  // namespace pmts::calibration
