#include "geodimeter_state.hpp"

#include "exchange.hpp"

#include <algorithm>

namespace pmts::instrument {
namespace {

/// Each routine has a stop source of its own: the last one's stays stopped.
std::function<void()> stopperOfNewRoutine(GeodimeterState& state) {
    state.routine_stop = std::stop_source();
    return [source = state.routine_stop]() mutable { source.request_stop(); };
}

}  // namespace

int patience(const GeodimeterState& state) {
    constexpr int kOnANoisyLine = 12;
    return state.quality.isNoisy() ? std::max(state.settings.retries, kOnANoisyLine) : state.settings.retries;
}

Routine::Routine(StatePtr state, Activity activity, std::stop_token caller,
                 std::optional<core::Duration> usual)
    : state_(std::move(state)), on_caller_(std::move(caller), stopperOfNewRoutine(*state_)) {
    state_->busy = true;
    state_->stop_sent = false;
    state_->progress.begin(activity, usual);
}

Routine::~Routine() {
    state_->busy = false;
    state_->progress.end();
}

core::Error busyError() {
    return {.kind = core::ErrorKind::kRefused,
            .happened = QObject::tr("The instrument is busy."),
            .remedy = QObject::tr("Wait until it is ready, or stop it."),
            .info_code = std::nullopt,
            .detail = {}};
}

core::Error unitsUnknownError() {
    return {.kind = core::ErrorKind::kRefused,
            .happened = QObject::tr(
                "The units of the instrument are not known; it is not moved and no angle is believed."),
            .remedy = QObject::tr("Set the units in the instrument's profile, or make label 23 readable."),
            .info_code = std::nullopt,
            .detail = {}};
}

std::optional<core::Error> refusal(const GeodimeterState& state, bool needs_units) {
    if (state.line == nullptr) {
        return core::cancelled().value();
    }
    if (!state.identity && !state.units) {
        return core::fail(core::ErrorKind::kNotConnected, QObject::tr("No instrument is connected."),
                          QObject::tr("Connect one first."))
            .value();
    }
    if (needs_units && !state.units) {
        return unitsUnknownError();
    }
    if (needs_units && state.settings_lost && !state.busy) {
        return state.settings_lost;
    }
    return state.busy ? std::optional(busyError()) : std::nullopt;
}

void sendStop(const StatePtr& state) {
    if (state->line == nullptr || state->stop_sent || state->loading_file || state->is_asked) {
        return;
    }
    state->stop_sent = state->busy;
    state->mode_selected = state->mode_selected && state->settings.stop_text.empty();
    state->distance_is_ours = false;
    state->track.is_still = false;
    Question question = commandQuestion(*state, protocol::SetMode{.mode = state->mode});
    if (!state->settings.stop_text.empty()) {
        question.bytes = state->settings.stop_text + '\r';
    }
    question.priority = scheduler::Priority::kStop;
    question.interrupts = true;
    [[maybe_unused]] const auto stopping = exchange(state, question, {});  // runs on by itself
}

namespace {

constexpr std::string_view kSetsUnits = "WG,23=", kSetsEndMark = "WG,79=";

/// What a panel writes into label 79 holds for its own answer already.
void followEndMark(GeodimeterState& state, std::string_view data) {
    data = data.substr(0, data.find_first_of("\r\n"));
    if (const auto mark = protocol::endMarkFromLabel(data); mark && state.line != nullptr) {
        state.line->setEndMark(*mark);
    }
}

}  // namespace

bool noteForeignCommand(GeodimeterState& state, std::string_view command) {
    command.remove_prefix(std::min(command.find_first_of("RWPTOLKM"), command.size()));
    state.distance_is_ours = false;
    state.foreign_command_at = state.clock.now();
    const bool only_reads = command.find_first_of("RMO") == 0;
    if (only_reads) {
        return false;
    }
    state.track.is_still = false;
    state.mode_selected = state.mode_selected && command.starts_with('W');
    if (command.starts_with(kSetsUnits) && !state.settings.unit_override) {
        state.units.reset();  // no reading is believed before they are known again
    } else if (command.starts_with(kSetsEndMark)) {
        followEndMark(state, command.substr(kSetsEndMark.size()));
    }
    return command.starts_with(kSetsUnits) || command.starts_with(kSetsEndMark);
}

}  // namespace pmts::instrument
