#pragma once

#include "sweep_residuals.hpp"

namespace pmts::calibration {

/// One least squares solution of a sweep.
struct SweepFit {
    SweepState state;
    SweepUnknowns unknowns;
    Eigen::VectorXd residuals_px;  ///< of every picture, used or not
    Eigen::MatrixXd jacobian;      ///< rows of pictures not used are zero
    std::vector<double> weights;   ///< 0 or 1 for each picture
    double sigma0_px = 0.0;

    [[nodiscard]] double rms_px() const;  ///< over the coordinates used
    /// Of one coordinate: no picture is seen better than the matcher can, however well a few of them agree.
    [[nodiscard]] double precisionSigma_px() const { return sigma0_px > 0.01 ? sigma0_px : 0.01; }
};

/// Fits the unknowns to the pictures with a weight; nothing is rejected.
[[nodiscard]] core::Result<SweepFit> fitSweep(const SweepState& start, const SweepUnknowns& unknowns,
                                              const std::vector<double>& weights);

/// The same with pictures that contradict the others taken out: first down-weighted (Cauchy), then left out
/// beyond five times the spread of the rest.
[[nodiscard]] core::Result<SweepFit> fitSweepRobustly(const SweepState& start, const SweepUnknowns& unknowns);

/// Root mean square of the coordinates of these pictures.
[[nodiscard]] double rmsOf(const Eigen::VectorXd& residuals_px, const std::vector<bool>& pictures);

}  // namespace pmts::calibration
