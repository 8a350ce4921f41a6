#pragma once

#include "pmts/core/clock.hpp"

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>

namespace pmts::scheduler {

struct TtSettings {
    double quantile =
        0.98;  ///< of the latest good times: one slow shot must not set L for ever (features 4.9)
    std::size_t window = 200;      ///< how many good times count
    std::size_t least_sample = 8;  ///< before that the initial L holds
};

/// Times taken (TT, thesis 8.4.2) by good transactions of one kind, and the limit L learned from them.
/// Keys are the caller's: `STD 0-50 m`, `read label`.
class TtStatistics {
public:
    explicit TtStatistics(TtSettings settings = {}) : settings_(settings) {}

    /// Good ones only: a time-out says nothing about how long a good one takes.
    void add(const std::string& key, core::Duration time_taken);
    [[nodiscard]] std::size_t count(const std::string& key) const;
    /// By rank; absent without a sample.
    [[nodiscard]] std::optional<core::Duration> quantile(const std::string& key, double q) const;
    /// L: the learned quantile, `initial` until enough are known, never above `cap`. The wait limit is WT = L
    /// + ET; since times up to WT are seen, L follows a site that becomes slower by at most ET a shot.
    [[nodiscard]] core::Duration limit(const std::string& key, core::Duration initial,
                                       core::Duration cap) const;

private:
    TtSettings settings_;
    std::map<std::string, std::deque<core::Duration>> times_;
};

}  // namespace pmts::scheduler
