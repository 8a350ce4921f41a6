#pragma once

#include <vector>

namespace pmts::camera {

/// Where a polynomial c[0] + c[1] s + c[2] s2 ... crosses zero between 0 and `last`, in rising order. Exact
/// to rounding: between two turning points, which are found the same way, it is monotone.
[[nodiscard]] std::vector<double> crossings(const std::vector<double>& coefficients, double last);

/// The first of them; infinity when there is none.
[[nodiscard]] double firstCrossing(const std::vector<double>& coefficients, double last);

}  // namespace pmts::camera
