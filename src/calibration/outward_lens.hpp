#pragma once

#include "pmts/camera/lens.hpp"

namespace pmts::calibration {

/// The same lens out to `seen_radius` (a tangent), but bending on steadily beyond: the polynomial of k1 and k2
/// runs away there (with k1 alone it even folds back), the quotient (1 + a r2) / (1 + b r2) that fits it where
/// it was seen does not. Left as it is where that quotient would run away itself.
[[nodiscard]] camera::Lens continuedOutward(const camera::Lens& lens, double seen_radius);

}  // namespace pmts::calibration
