#include "support/figure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace pmts::bench {

void figure(const std::string& name, double value, const std::string& unit, Wanted wanted, double target) {
    const bool ok = wanted == Wanted::kAtMost ? value <= target : value >= target;
    std::printf("%s %.4g %s %s%.4g %s\n", name.c_str(), value, unit.c_str(), wanted == Wanted::kAtMost ? "<=" : ">=",
                target, ok ? "ok" : "SHORT");
    std::fflush(stdout);
}

double quantile(std::vector<double> sample, double q) {
    if (sample.empty()) {
        throw std::logic_error("quantile of an empty sample");
    }
    const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(sample.size())));
    const auto nth = sample.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(sample.begin(), nth, sample.end());
    return *nth;
}

double median(std::vector<double> sample) { return quantile(std::move(sample), 0.5); }

}  // namespace pmts::bench
