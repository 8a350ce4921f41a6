#include "standing_warnings.hpp"

#include "pmts/protocol/info_code.hpp"

#include <algorithm>
#include <utility>

namespace pmts::instrument {
namespace {

constexpr int kWaitedInVain = 23;
constexpr int kComplaintsToTell = 3;  ///< one is healed by asking again

bool isOfLostSettings(const core::Error& warning) { return warning.info_code && meansLostSettings(*warning.info_code); }

}  // namespace

void StandingWarnings::note(const std::optional<protocol::Status>& status) {
    if (!status) {
        return;
    }
    const bool lost_settings = meansLostSettings(status->code);
    const bool complains = status->code == kWaitedInVain && ++complaints_ >= kComplaintsToTell;
    if (!lost_settings && !complains && !protocol::isWarning(status->code)) {
        return;
    }
    seen_ = seen_ || !lost_settings;
    const auto same = [&](const core::Error& known) { return known.info_code == status->code; };
    if (std::ranges::none_of(standing_, same)) {
        standing_.push_back(protocol::errorFromStatus(*status));
        if (report) {
            report(standing_);
        }
        if (lost_settings && on_settings_lost) {
            asks_again_ = true;
            on_settings_lost(standing_.back());
        }
    }
}

void StandingWarnings::endMeasurement() {
    if (!seen_) {
        complaints_ = 0;
        keepOnly(isOfLostSettings);
    }
}

void StandingWarnings::forget() {
    complaints_ = 0;
    const bool asks_again = std::exchange(asks_again_, false);
    keepOnly([asks_again](const core::Error& warning) { return asks_again && isOfLostSettings(warning); });
}

void StandingWarnings::keepOnly(const std::function<bool(const core::Error&)>& stands_on) {
    if (std::erase_if(standing_, [&](const core::Error& warning) { return !stands_on(warning); }) > 0 && report) {
        report(standing_);
    }
}

}  // namespace pmts::instrument
