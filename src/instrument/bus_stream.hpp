#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/geometry/pointing.hpp"

#include <optional>
#include <string_view>

namespace pmts::instrument {

/// `A,166=96.16838 CR A,165=177.56115`: VA and HA, always gon with five decimals (protocol page 5.2). nullopt: damaged.
[[nodiscard]] std::optional<geometry::Pointing> pointingOfStream(std::string_view block);

/// Which readings of the running stream are believed. There is no check sum, and one changed digit makes another angle: a
/// reading counts when it lies where the last one did, or when the next one (the next three on a line that damaged a block
/// lately) confirms that the instrument is turning. Only a change within the noise of a reading, 20 cc, is not seen.
class BusStream {
public:
    [[nodiscard]] std::optional<geometry::Pointing> take(std::string_view block, core::Duration at);
    void forget() { *this = {}; }

private:
    struct Reading {
        geometry::Pointing pointing;
        core::Duration at;
    };
    [[nodiscard]] bool isNoisy(core::Duration at) const;
    std::optional<Reading> believed_, doubtful_;
    int in_row_ = 0;  ///< doubtful ones that each fit the one before
    bool is_turning_ = false;
    std::optional<core::Duration> damaged_at_;
};

}  // namespace pmts::instrument
