#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/simulator/station_settings.hpp"

#include <functional>
#include <optional>
#include <random>

namespace pmts::simulator {

enum class DistanceState { kNone, kMeasuring, kAvailableNew, kAvailableRecorded, kFailed };

/// Modes of PG,3.
enum class EdmMode { kStd = 0, kTrk = 1, kDBar = 2, kFastStd = 3, kDBarHighResolution = 4 };

enum class RangeChoice { kNormal, kShort, kLong };

/// The unit that measures distances: when a value is there, how good it is, and what is known of it.
/// Without an echo it tries without end and says nothing, unless the settings give it a status to give up
/// with.
class DistanceMeter {
public:
    /// `echo_m`: the length of the light's way to what the telescope points at now; nullopt without signal.
    DistanceMeter(const StationSettings& settings, core::Clock& clock,
                  std::function<std::optional<double>()> echo_m);

    void trigger(RangeChoice range);
    void selectMode(EdmMode mode);  ///< ends what runs and forgets the distance
    void stop();                    ///< a distance that is already there stays
    void forget();
    void failNext(int status) { fail_next_ = status; }
    void delayNext(core::Duration extra) { delay_next_ = extra; }
    void markRecorded();

    [[nodiscard]] EdmMode mode() const { return mode_; }
    [[nodiscard]] bool averages() const {
        return mode_ == EdmMode::kDBar || mode_ == EdmMode::kDBarHighResolution;
    }
    [[nodiscard]] DistanceState state() const { return state_; }
    [[nodiscard]] bool isRunning() const { return running_; }
    [[nodiscard]] bool hasDistance() const;
    [[nodiscard]] double distance() const {
        return mean_m_;
    }                                        ///< as the light counts it, without any correction
    [[nodiscard]] double deviation() const;  ///< of the mean, from its readings; 0 for one
    [[nodiscard]] int failure() const { return failure_; }

    std::function<void()> on_distance;  ///< each new value
    std::function<void()> on_end;       ///< nothing runs any more: STD done, stopped or failed
    std::function<bool()> is_turning;   ///< all modes but TRK wait for the axes to stand still

private:
    void expectReading(core::Duration after);
    void takeReading();
    void keep(double reading_m);
    void end(DistanceState state);
    [[nodiscard]] core::Duration firstReadingAfter(RangeChoice range) const;
    [[nodiscard]] EdmAccuracy accuracy() const;

    const StationSettings& settings_;
    core::Clock& clock_;
    std::function<std::optional<double>()> echo_m_;
    std::mt19937 random_;
    EdmMode mode_ = EdmMode::kStd;
    DistanceState state_ = DistanceState::kNone;
    bool running_ = false;
    int readings_ = 0;
    double mean_m_ = 0.0;
    double squares_m2_ = 0.0;
    int failure_ = 0;
    std::optional<int> fail_next_;
    core::Duration delay_next_{0};
    core::Timer timer_;
};

}  // namespace pmts::simulator
