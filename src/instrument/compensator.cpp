#include "compensator.hpp"

namespace pmts::instrument {
namespace {

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
            const bool silent = heard.error().kind == core::ErrorKind::kTimeOut;
            auto ending = endInSilence(state, run, heard.error(), stop);
            co_return silent ? co_await ending : core::Result<CompensatorRun>(tl::unexpected(heard.error()));
        }
        if (heard->raw == "@") {
            run.showed_compensator = true;
        } else if (heard->raw == "!") {
            auto asking = on_question().answer();  // its handle goes: whoever asks may drop the question
            const auto yes = co_await asking;
            next = yes.value_or(false) ? "Y\r" : "N\r";
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
