#pragma once

#include "pmts/calibration/self_calibration.hpp"

#include <ceres/cost_function.h>

namespace pmts::calibration {

/// What one fit changes: these parameters of the rig, and the direction of each spot that was not sighted.
struct SweepUnknowns {
    std::vector<RigParameter> rig;
    std::vector<std::size_t> directions;  ///< indices of spots; HA and VA in rad each, after the rig's

    [[nodiscard]] Eigen::Index count() const {
        return static_cast<Eigen::Index>(rig.size() + 2 * directions.size());
    }
};

/// The unknowns' values put into a rig and spots.
struct SweepState {
    camera::Rig rig;
    std::vector<SweptSpot> spots;
};

[[nodiscard]] Eigen::VectorXd valuesOf(const SweepState& state, const SweepUnknowns& unknowns);
/// Nothing when they make no camera.
[[nodiscard]] std::optional<SweepState> stateWith(const SweepState& start, const SweepUnknowns& unknowns,
                                                  const Eigen::VectorXd& values);
/// Modelled less seen pixel of every picture, spot after spot; nothing when one with a weight has no pixel.
[[nodiscard]] std::optional<Eigen::VectorXd> sweepResiduals(const SweepState& state,
                                                            const std::vector<double>& weights);

/// All residuals over one block, each times the root of its weight. Numeric derivatives, so that the fitted
/// model is the one the program aims with; a direction moves the pictures of its own spot only.
class SweepCost final : public ceres::CostFunction {
public:
    SweepCost(const SweepState& start, const SweepUnknowns& unknowns, const std::vector<double>& weights);

    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

private:
    [[nodiscard]] std::optional<Eigen::VectorXd> weighted(const Eigen::VectorXd& values) const;

    const SweepState& start_;
    const SweepUnknowns& unknowns_;
    const std::vector<double>& weights_;
};

}  // namespace pmts::calibration
