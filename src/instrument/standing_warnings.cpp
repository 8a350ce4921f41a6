#include "standing_warnings.hpp"

#include "pmts/protocol/info_code.hpp"

#include <algorithm>

namespace pmts::instrument {

void StandingWarnings::note(const std::optional<protocol::Status>& status) {
    if (!status || !protocol::isWarning(status->code)) {
        return;
    }
    seen_ = true;
    const auto same = [&](const core::Error& known) { return known.info_code == status->code; };
    if (std::ranges::none_of(standing_, same)) {
        standing_.push_back(protocol::errorFromStatus(*status));
        if (report) {
            report(standing_);
        }
    }
}

void StandingWarnings::endMeasurement() {
    if (!seen_) {
        forget();
    }
}

void StandingWarnings::forget() {
    if (standing_.empty()) {
        return;
    }
    standing_.clear();
    if (report) {
        report(standing_);
    }
}

}  // namespace pmts::instrument
