#pragma once

#include "pmts/instrument/geodimeter_driver.hpp"
#include "pmts/protocol/info_code.hpp"
#include "pmts/protocol/labels.hpp"
#include "progress_reporter.hpp"
#include "standing_warnings.hpp"

#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace pmts::instrument {

/// How much the line is trusted: after any trouble it counts as noisy for the next few hundred clean
/// exchanges.
class LineQuality {
public:
    void trouble() { doubt_ = kDoubtLasts; }
    void clean() { doubt_ -= doubt_ > 0 ? 1 : 0; }
    [[nodiscard]] bool isNoisy() const { return doubt_ > 0; }
    /// By how many readings a value must lead over every other. On a line that loses one byte in twenty a
    /// reading is right twelve times as often as it lacks one certain digit: a lead of six is wrong once in a
    /// million values.
    [[nodiscard]] int leadNeeded() const { return isNoisy() ? 6 : 2; }

private:
    static constexpr int kDoubtLasts = 300;
    int doubt_ = 0;
};

/// The count of decimals a value usually has: a number with another count has lost or gained a digit. The
/// operator may change the count (menu 13), so that another one is believed when it comes several times in a
/// row.
class UsualDecimals {
public:
    [[nodiscard]] bool believe(int decimals);

private:
    static constexpr int kInRowToChange = 5;
    std::optional<int> usual_;
    int other_ = 0;
    int in_row_ = 0;
};

/// The latest readings of the circles that were believed.
struct PointingTrack {
    std::optional<core::Angle> ha, va;
    core::Duration at{0};
    std::optional<core::Angle> doubtful_ha, doubtful_va;  ///< read once, not yet confirmed
    bool is_still = false;  ///< verified after a turn of ours, nothing has moved the instrument since
};

/// What a driver's routines share. Held by each of them, so that a routine may outlive the driver that began
/// it.
struct GeodimeterState {
    GeodimeterState(scheduler::Scheduler& the_line, core::Clock& the_clock, GeodimeterSettings the_settings)
        : line(&the_line), clock(the_clock), settings(std::move(the_settings)) {}

    scheduler::Scheduler* line;     ///< null once the driver is gone
    TotalStation* front = nullptr;  ///< for its callbacks; null once the driver is gone
    core::Clock& clock;
    GeodimeterSettings settings;

    std::optional<Identity> identity;
    std::optional<protocol::WireUnits> units;
    std::optional<core::Error> settings_lost;  ///< info 50, 51, 54: units may be others, nothing is begun with them
    EdmMode mode = EdmMode::kStd;
    bool mode_selected = false;     ///< the instrument is known to be in `mode`
    bool distance_is_ours = false;  ///< no distance is waiting in the instrument that we have not seen
    std::optional<core::Duration> foreign_command_at;  ///< the latest of a panel
    bool targets_readable = true;   ///< RG,26 and RG,27 answer
    std::optional<double> expected_range_m;
    int settling_label = protocol::kEndMark;  ///< a label that is known to answer: read to settle the line

    LineQuality quality;
    int silences_in_row = 0;                ///< questions without a single byte of answer
    bool trigger_answers_at_once = false;   ///< as seen so far: then a TG without block end is a lost one
    int motions_as_expected = 0;            ///< motions that took about the time their way needs
    std::map<int, UsualDecimals> decimals;  ///< by label
    PointingTrack track;
    scheduler::TtStatistics statistics;
    ProgressReporter progress{clock};
    StandingWarnings warnings;

    bool busy = false;
    bool loading_file = false;      ///< what is written now becomes part of a file in the instrument
    bool is_asked = false;          ///< the instrument waits for yes or no
    bool stop_sent = false;         ///< for the running routine
    std::stop_source routine_stop;  ///< of the running routine
};

using StatePtr = std::shared_ptr<GeodimeterState>;

/// How often a question is repeated: on a line that loses bytes patience is what helps.
[[nodiscard]] int patience(const GeodimeterState& state);

/// One routine at a time: marks the driver busy, joins the caller's token with stop(), reports progress.
class Routine {
public:
    Routine(StatePtr state, Activity activity, std::stop_token caller, std::optional<core::Duration> usual);
    ~Routine();
    Routine(const Routine&) = delete;
    Routine& operator=(const Routine&) = delete;

    [[nodiscard]] std::stop_token token() const { return state_->routine_stop.get_token(); }

private:
    StatePtr state_;
    std::stop_callback<std::function<void()>> on_caller_;
};

[[nodiscard]] core::Error busyError();
[[nodiscard]] core::Error unitsUnknownError();
/// What forbids a routine right now; nullopt when it may run.
[[nodiscard]] std::optional<core::Error> refusal(const GeodimeterState& state, bool needs_units);
/// GeodimeterDriver::noteForeignCommand().
[[nodiscard]] bool noteForeignCommand(GeodimeterState& state, std::string_view command);
/// Writes the stop text at once, even into a running transaction.
void sendStop(const StatePtr& state);

}  // namespace pmts::instrument
