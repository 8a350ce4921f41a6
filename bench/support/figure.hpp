#pragma once

#include <string>
#include <vector>

namespace pmts::bench {

enum class Wanted { kAtMost, kAtLeast };

/// Prints one line `room.name value unit target ok|SHORT` and counts the short ones.
void figure(const std::string& name, double value, const std::string& unit, Wanted wanted, double target);

/// Median of a sample; throws std::logic_error when empty.
[[nodiscard]] double median(std::vector<double> sample);
/// Quantile by rank, 0.99 for p99.
[[nodiscard]] double quantile(std::vector<double> sample, double q);

}  // namespace pmts::bench
