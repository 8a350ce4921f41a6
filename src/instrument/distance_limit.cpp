#include "distance_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::instrument {
namespace {

constexpr std::array kRangeClasses{50.0, 200.0, 1000.0};

const char* modeName(EdmMode mode) {
    switch (mode) {
        case EdmMode::kStd:
            return "STD";
        case EdmMode::kTrk:
            return "TRK";
        case EdmMode::kDBar:
            return "D-bar";
        case EdmMode::kFstd:
            return "FSTD";
        case EdmMode::kDBarHighResolution:
            return "D-bar high resolution";
    }
    return "";
}

std::vector<std::string> keysOf(EdmMode mode) {
    std::vector<std::string> keys;
    for (const double upper_m : kRangeClasses) {
        keys.push_back(timingKey(mode, upper_m - 1.0));
    }
    keys.push_back(timingKey(mode, 1e9));
    return keys;
}

}  // namespace

bool averages(EdmMode mode) { return mode == EdmMode::kDBar || mode == EdmMode::kDBarHighResolution; }

const EdmTiming& timingOf(const GeodimeterState& state) {
    return state.settings.edm.at(static_cast<std::size_t>(state.mode));
}

std::optional<core::Duration> usualTime(const GeodimeterState& state, double q) {
    std::optional<core::Duration> usual;
    for (const auto& key : keysOf(state.mode)) {
        if (const auto known = state.statistics.quantile(key, q); known && (!usual || *known < *usual)) {
            usual = known;
        }
    }
    return usual;
}

std::string timingKey(EdmMode mode, double slope_distance_m) {
    double lower_m = 0.0;
    for (const double upper_m : kRangeClasses) {
        if (slope_distance_m < upper_m) {
            return std::string(modeName(mode)) + ' ' + std::to_string(std::lround(lower_m)) + '-' +
                   std::to_string(std::lround(upper_m)) + " m";
        }
        lower_m = upper_m;
    }
    return std::string(modeName(mode)) + " beyond " + std::to_string(std::lround(lower_m)) + " m";
}

core::Duration learnedLimit(const GeodimeterState& state) {
    const auto& known = timingOf(state);
    const auto averaging = averages(state.mode) ? state.settings.averaging_time : core::Duration{0};
    if (state.expected_range_m) {
        return std::max(state.statistics.limit(timingKey(state.mode, *state.expected_range_m),
                                               known.initial_limit, known.cap),
                        averaging);
    }
    std::optional<core::Duration> longest;
    for (const auto& key : keysOf(state.mode)) {
        if (state.statistics.count(key) > 0) {
            longest = std::max(longest.value_or(core::Duration{0}),
                               state.statistics.limit(key, known.initial_limit, known.cap));
        }
    }
    return std::max(longest.value_or(known.initial_limit), averaging);
}

}  // namespace pmts::instrument
