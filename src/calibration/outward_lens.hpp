#pragma once

#include "pmts/camera/lens.hpp"

namespace pmts::calibration {

/// The same lens near the middle, but bending on steadily beyond what was seen of it: a polynomial with its
/// last terms of opposite sign runs away there (with k1 alone it even folds back), the quotient with the same
/// first terms (Padé) does not. Lenses without such terms are left as they are.
[[nodiscard]] camera::Lens continuedOutward(const camera::Lens& lens);

}  // namespace pmts::calibration
