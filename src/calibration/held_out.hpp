#pragma once

#include "residual_table_fit.hpp"
#include "sweep_fit.hpp"

namespace pmts::calibration {

[[nodiscard]] std::vector<bool> usedPictures(const SweepFit& fit);

/// The fit without each of so many parts of its pictures; picture i is in part i modulo the number of parts.
[[nodiscard]] core::Result<std::vector<SweepFit>> fitWithoutParts(const SweepFit& fit, int parts);

/// Of every picture, what the fit that did not see it makes of it.
[[nodiscard]] Eigen::VectorXd heldOutResiduals(const SweepFit& fit, const std::vector<SweepFit>& left_out);
/// The same with a table on top, fitted to what each of those fits left over of its own pictures.
[[nodiscard]] Eigen::VectorXd heldOutWithTable(const SweepFit& fit, const std::vector<SweepFit>& left_out,
                                               const TableStiffness& stiffness);
/// What this fit leaves over of the pictures it used, as a surface.
[[nodiscard]] ResidualSurface surfaceOver(const SweepFit& fit, const TableStiffness& stiffness);

/// What a fit leaves over of these pictures.
[[nodiscard]] std::vector<LeftOver> leftOver(const SweepFit& fit, const std::vector<bool>& pictures);

}  // namespace pmts::calibration
