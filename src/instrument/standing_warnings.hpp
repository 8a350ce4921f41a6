#pragma once

#include "pmts/core/result.hpp"
#include "pmts/protocol/reply.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace pmts::instrument {

/// Codes after which the settings of the instrument may be others than before, units among them: configuration damaged (50),
/// check sum wrong (51), memory lost (54).
[[nodiscard]] constexpr bool meansLostSettings(int code) { return code == 50 || code == 51 || code == 54; }

/// What the instrument warns of (protocol::isWarning) while it goes on working. A warning is told once and stands until
/// a whole measurement brought none, or a new connection begins. Info 23 is one when it comes again and again (wrong pins of
/// the plug are driven). Lost settings (meansLostSettings) stand until a new connection begins.
class StandingWarnings {
public:
    void note(const std::optional<protocol::Status>& status);
    void beginMeasurement() { seen_ = false; }
    void endMeasurement();
    /// A new connection begins. What was known is asked for again after lost settings: those go on standing once.
    void forget();

    std::function<void(const std::vector<core::Error>&)> report;  ///< all that stand, at every change
    std::function<void(const core::Error&)> on_settings_lost;  ///< once, when they begin to stand

private:
    void keepOnly(const std::function<bool(const core::Error&)>& stands_on);

    std::vector<core::Error> standing_;
    bool seen_ = false;  ///< since the measurement began
    int complaints_ = 0;  ///< info 23, since a measurement without
    bool asks_again_ = false;
};

}  // namespace pmts::instrument
