#pragma once

#include "pmts/calibration/rig_fit.hpp"

#include <ceres/cost_function.h>

namespace pmts::calibration {

/// Modelled less observed pixel of one sighting.
[[nodiscard]] core::Result<Eigen::Vector2d> pixelResidual(const camera::Rig& rig, const Sighting& sighting);

/// All residuals over one block of free parameters. The derivatives are numeric, so that the fitted model is
/// exactly the one the program aims with; at the edge of the model (fold, behind the camera) they become
/// one-sided, where Ceres's own numeric differentiation would end the fit.
class PixelResiduals final : public ceres::CostFunction {
public:
    PixelResiduals(const std::vector<Sighting>& sightings, const camera::Rig& initial,
                   const std::vector<RigParameter>& free);

    /// False where a sighting has no pixel: the solver then takes a shorter step.
    bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

private:
    [[nodiscard]] std::optional<Eigen::VectorXd> residualsAt(const Eigen::VectorXd& values) const;
    [[nodiscard]] std::optional<Eigen::VectorXd> derivative(const Eigen::VectorXd& values,
                                                            const Eigen::VectorXd& here,
                                                            Eigen::Index parameter) const;

    const std::vector<Sighting>& sightings_;
    const camera::Rig& initial_;
    const std::vector<RigParameter>& free_;
};

}  // namespace pmts::calibration
