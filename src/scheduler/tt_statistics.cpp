#include "pmts/scheduler/tt_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace pmts::scheduler {

void TtStatistics::add(const std::string& key, core::Duration time_taken) {
    auto& times = times_[key];
    times.push_back(time_taken);
    if (times.size() > settings_.window) {
        times.pop_front();
    }
}

std::size_t TtStatistics::count(const std::string& key) const {
    const auto found = times_.find(key);
    return found == times_.end() ? 0 : found->second.size();
}

std::optional<core::Duration> TtStatistics::quantile(const std::string& key, double q) const {
    if (q <= 0.0 || q > 1.0) {
        throw std::logic_error("a quantile lies in (0, 1]");
    }
    const auto found = times_.find(key);
    if (found == times_.end()) {
        return std::nullopt;
    }
    std::vector<core::Duration> sorted(found->second.begin(), found->second.end());
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(q * static_cast<double>(sorted.size()))) - 1;
    const auto nth = sorted.begin() + std::max<std::ptrdiff_t>(rank, 0);
    std::nth_element(sorted.begin(), nth, sorted.end());
    return *nth;
}

core::Duration TtStatistics::limit(const std::string& key, core::Duration initial, core::Duration cap) const {
    const bool known = count(key) >= settings_.least_sample;
    return std::min(known ? *quantile(key, settings_.quantile) : initial, cap);
}

}  // namespace pmts::scheduler
