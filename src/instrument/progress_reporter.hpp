#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/instrument/total_station.hpp"

#include <functional>
#include <optional>

namespace pmts::instrument {

/// Says ten times a second how far the running routine is, from its beginning to its end.
class ProgressReporter {
public:
    explicit ProgressReporter(core::Clock& clock) : clock_(clock) {}

    void begin(Activity activity, std::optional<core::Duration> usual);
    void end();

    std::function<void(const Progress&)> report;

private:
    void tick();

    core::Clock& clock_;
    core::Timer timer_;
    Activity activity_ = Activity::kIdle;
    std::optional<core::Duration> usual_;
    core::Duration began_at_{0};
};

}  // namespace pmts::instrument
