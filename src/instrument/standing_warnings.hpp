#pragma once

#include "pmts/core/result.hpp"
#include "pmts/protocol/reply.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace pmts::instrument {

/// What the instrument warns of (protocol::isWarning) while it goes on working. A warning is told once and stands until
/// a whole measurement brought none, or a new connection begins.
class StandingWarnings {
public:
    void note(const std::optional<protocol::Status>& status);
    void beginMeasurement() { seen_ = false; }
    void endMeasurement();
    void forget();

    std::function<void(const std::vector<core::Error>&)> report;  ///< all that stand, at every change

private:
    std::vector<core::Error> standing_;
    bool seen_ = false;  ///< since the measurement began
};

}  // namespace pmts::instrument
