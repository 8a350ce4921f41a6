#pragma once

#include "pmts/calibration/rig_fit.hpp"

namespace pmts::calibration {

/// The value of a parameter in this rig; the lens is a BrownLens.
[[nodiscard]] double parameterOf(const camera::Rig& rig, RigParameter parameter);

/// `initial` with these parameters replaced; nothing when the focal length is not positive.
[[nodiscard]] std::optional<camera::Rig> rigWith(const camera::Rig& initial,
                                                 const std::vector<RigParameter>& parameters,
                                                 const double* values);

}  // namespace pmts::calibration
