#pragma once

#include "sweep_fit.hpp"

namespace pmts::calibration {

/// Standard deviations of the unknowns (absent: the pictures say nothing of it) and their covariance.
struct SweepPrecision {
    std::vector<std::optional<double>> deviations;
    Eigen::MatrixXd correlation;
    Eigen::VectorXd weakest;  ///< the direction known worst, in units of each unknown's own effect
};

[[nodiscard]] SweepPrecision precisionOf(const SweepFit& fit);

/// A fit of everything the pictures can tell: unknowns that are too weak are held one after the other, those
/// first that matter least when they are wrong together with their partner.
struct DeterminedFit {
    SweepFit fit;
    SweepPrecision precision;
    std::vector<HeldParameter> held;
};
[[nodiscard]] core::Result<DeterminedFit> fitDeterminable(const SweepState& start, SweepUnknowns unknowns);

}  // namespace pmts::calibration
