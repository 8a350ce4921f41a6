#include "compensator.hpp"

namespace pmts::instrument {
namespace {

const std::string kYes = "Y\r", kNo = "N\r";  ///< not stated on the page: the default of the simulator

/// The next step of the dialogue: what is said, and who hears until the next prompt or block.
scheduler::MicroInstruction listen(const GeodimeterState& state, const scheduler::Hold& hold, std::string bytes) {
    scheduler::MicroInstruction instruction;
    instruction.bytes = std::move(bytes);
    instruction.time_limit = state.settings.calibration_limit;
    instruction.time_critical = true;
    instruction.prompts = "@!";
    instruction.accepts = canAnswerWrite;
    instruction.hold = hold;
    return instruction;
}

/// No block end of PV,20 is documented: an instrument that answers questions again is through.
core::Task<core::Result<CompensatorRun>> endInSilence(StatePtr state, CompensatorRun run, core::Error silence,
                                                      std::stop_token stop) {
    auto settling = settleLine(state, stop);
    const bool answers = co_await settling;
    if (!answers || !run.showed_compensator) {
        co_return tl::unexpected(silence);
    }
    co_return run;
}

/// Marks that whatever is written now is taken for yes or no: a stop is not sent then.
class Asked {
public:
    explicit Asked(StatePtr state) : state_(std::move(state)) { state_->is_asked = true; }
    ~Asked() { state_->is_asked = false; }
    Asked(const Asked&) = delete;
    Asked& operator=(const Asked&) = delete;

private:
    StatePtr state_;
};

core::Task<core::Result<bool>> answerOf(StatePtr state, std::function<core::Completion<bool>()> on_question) {
    const Asked asked(state);
    auto asking = on_question().answer();  // its handle goes: whoever asks may drop the question
    co_return co_await asking;
}

/// Nobody answers any more, but the instrument waits: with the token of the routine nothing would be written.
core::Task<void> refuse(StatePtr state, scheduler::Hold hold) {
    if (state->line != nullptr) {
        auto instruction = listen(*state, hold, kNo);
        instruction.time_limit = state->settings.write_limit;
        auto refusing = state->line->execute(std::move(instruction), {});
        [[maybe_unused]] const auto refused = co_await refusing;
    }
}

core::Task<core::Result<CompensatorRun>> converse(StatePtr state, std::function<core::Completion<bool>()> on_question,
                                                  std::stop_token stop) {
    CompensatorRun run;
    auto hold = state->line->hold();
    std::string next = protocol::encode(protocol::CalibrateCompensator{});
    while (state->line != nullptr) {
        auto listening = state->line->execute(listen(*state, hold, next), stop);
        const auto heard = co_await listening;
        next.clear();
        if (!heard) {
            hold.reset();
            if (heard.error().kind != core::ErrorKind::kTimeOut) {
                co_return tl::unexpected(heard.error());
            }
            auto ending = endInSilence(state, run, heard.error(), stop);
            co_return co_await ending;
        }
        if (heard->raw == "@") {
            run.showed_compensator = true;
        } else if (heard->raw == "!") {
            auto asking = answerOf(state, on_question);
            const auto yes = co_await asking;
            if (!yes || stop.stop_requested()) {
                auto refusing = refuse(state, hold);
                co_await refusing;
                co_return core::cancelled();
            }
            run.answered_no = !*yes;
            next = *yes ? kYes : kNo;
        } else if (const auto error = deviceError(checkBlock(*heard))) {
            co_return tl::unexpected(*error);
        } else {
            run.ended_by_block = true;
            co_return run;
        }
    }
    co_return core::cancelled();
}

}  // namespace

core::Task<core::Result<CompensatorRun>> calibrateCompensator(StatePtr state,
                                                              std::function<core::Completion<bool>()> on_question,
                                                              std::stop_token stop) {
    if (const auto refused = refusal(*state, false)) {
        co_return tl::unexpected(*refused);
    }
    const Routine routine(state, Activity::kTurning, stop, std::nullopt);
    auto settling = settleLine(state, routine.token());
    [[maybe_unused]] const bool settled = co_await settling;
    if (state->line == nullptr || routine.token().stop_requested()) {
        co_return core::cancelled();
    }
    state->track = {};
    state->distance_is_ours = false;
    auto talking = converse(state, std::move(on_question), routine.token());
    co_return co_await talking;
}

}  // namespace pmts::instrument
