#include "distance_meter.hpp"

#include <cmath>
#include <utility>

namespace pmts::simulator {

DistanceMeter::DistanceMeter(const StationSettings& settings, core::Clock& clock,
                             std::function<std::optional<double>()> echo_m)
    : settings_(settings),
      clock_(clock),
      echo_m_(std::move(echo_m)),
      random_(settings.seed * 2654435761U + 1U) {}

void DistanceMeter::trigger(RangeChoice range) {
    if (running_ && averages()) {
        const bool has_mean = readings_ > 0;  // the second A/M ends the averaging
        end(has_mean ? DistanceState::kAvailableNew : DistanceState::kNone);
        return;
    }
    running_ = true;
    state_ = DistanceState::kMeasuring;
    readings_ = 0;
    mean_m_ = squares_m2_ = 0.0;
    expectReading(firstReadingAfter(range) + std::exchange(delay_next_, core::Duration{0}));
}

void DistanceMeter::selectMode(EdmMode mode) {
    stop();
    forget();
    mode_ = mode;
}

void DistanceMeter::stop() {
    if (running_) {
        end(readings_ > 0 ? state_ : DistanceState::kNone);
    }
}

void DistanceMeter::forget() {
    if (!running_) {
        state_ = DistanceState::kNone;
        readings_ = 0;
    }
}

void DistanceMeter::markRecorded() {
    if (state_ == DistanceState::kAvailableNew) {
        state_ = DistanceState::kAvailableRecorded;
    }
}

bool DistanceMeter::hasDistance() const {
    return state_ == DistanceState::kAvailableNew || state_ == DistanceState::kAvailableRecorded;
}

double DistanceMeter::deviation() const {
    return readings_ < 2 ? 0.0 : std::sqrt(squares_m2_ / ((readings_ - 1.0) * readings_));
}

core::Duration DistanceMeter::firstReadingAfter(RangeChoice range) const {
    switch (mode_) {
        case EdmMode::kTrk:
            return settings_.trk_interval;
        case EdmMode::kFastStd:
            return settings_.fast_std_time;
        case EdmMode::kDBar:
        case EdmMode::kDBarHighResolution:
            return settings_.d_bar_first;
        case EdmMode::kStd:
            break;
    }
    if (settings_.reflectorless) {
        const double way_m = echo_m_().value_or(0.0);
        return settings_.dr_time +
               std::chrono::duration_cast<core::Duration>(settings_.dr_time_per_m * way_m);
    }
    return settings_.std_time +
           (range == RangeChoice::kLong ? settings_.long_range_extra : core::Duration{0});
}

EdmAccuracy DistanceMeter::accuracy() const {
    switch (mode_) {
        case EdmMode::kTrk:
            return settings_.trk_accuracy;
        case EdmMode::kFastStd:
            return settings_.fast_std_accuracy;
        case EdmMode::kDBar:
            return settings_.d_bar_accuracy;
        case EdmMode::kDBarHighResolution:
            return settings_.d_bar_high_resolution_accuracy;
        case EdmMode::kStd:
            break;
    }
    return {settings_.edm_sigma_m, settings_.edm_sigma_ppm};
}

void DistanceMeter::expectReading(core::Duration after) {
    timer_ = clock_.callAfter(after, [this] { takeReading(); });
}

void DistanceMeter::takeReading() {
    if (const auto status = std::exchange(fail_next_, std::nullopt)) {
        failure_ = *status;
        end(DistanceState::kFailed);
        return;
    }
    const bool waits = mode_ != EdmMode::kTrk && is_turning && is_turning();
    const auto way_m = waits ? std::nullopt : echo_m_();
    if (way_m) {
        keep(*way_m);
    } else if (!waits && settings_.no_signal_status != 0) {
        failure_ = settings_.no_signal_status;
        end(DistanceState::kFailed);
    } else {
        expectReading(settings_.retry_interval);
    }
}

void DistanceMeter::keep(double way_m) {
    const EdmAccuracy spread = accuracy();
    const double sigma_m = spread.constant_m + spread.ppm * 1e-6 * way_m;
    const double reading_m = sigma_m > 0.0 ? std::normal_distribution(way_m, sigma_m)(random_) : way_m;
    readings_ = averages() ? readings_ + 1 : 1;
    const double before_m = readings_ == 1 ? reading_m : mean_m_;
    mean_m_ = before_m + (reading_m - before_m) / readings_;
    squares_m2_ = readings_ == 1 ? 0.0 : squares_m2_ + (reading_m - before_m) * (reading_m - mean_m_);
    state_ = DistanceState::kAvailableNew;
    const bool goes_on = averages() || mode_ == EdmMode::kTrk;
    if (goes_on) {
        expectReading(averages() ? settings_.d_bar_interval : settings_.trk_interval);
    }
    if (on_distance) {
        on_distance();
    }
    if (!goes_on) {
        end(state_);
    }
}

void DistanceMeter::end(DistanceState state) {
    timer_.cancel();
    running_ = false;
    state_ = state;
    if (on_end) {
        on_end();
    }
}

}  // namespace pmts::simulator
