#include "exchange.hpp"

#include "pmts/core/logging.hpp"

#include <algorithm>

namespace pmts::instrument {
namespace {

using namespace std::chrono_literals;
using protocol::InfoClass;

const std::string kReadKey = "read label";
constexpr int kSettleAttempts = 12;
constexpr int kSilencesOfADeadLine = 3;
constexpr core::Duration kSettleLimit = 1s;
/// Info 197, the instrument is busy inside: doubled at each try.
constexpr core::Duration kBusyPause = 200ms;
/// A single read takes the wire time and little more; eight times the usual is a lost answer.
constexpr int kReadPatience = 8;

core::Error damagedAnswer(const protocol::Reply& reply) {
    return {.kind = core::ErrorKind::kProtocol,
            .happened = QStringLiteral("The answer of the instrument arrived damaged."),
            .remedy = QStringLiteral("Check the cable; the action can be repeated."),
            .info_code = std::nullopt,
            .detail = QString::fromLatin1(reply.raw.data(), static_cast<qsizetype>(reply.raw.size()))};
}

bool isTimeCritical(const GeodimeterState& state, const std::string& bytes) {
    return std::ranges::any_of(state.settings.time_critical,
                               [&](const std::string& start) { return bytes.starts_with(start); });
}

scheduler::MicroInstruction instructionFor(const GeodimeterState& state, const Question& question) {
    scheduler::MicroInstruction instruction;
    instruction.bytes = question.bytes;
    instruction.time_limit = question.limit;
    instruction.priority = question.priority;
    instruction.time_critical = isTimeCritical(state, question.bytes);
    instruction.interrupts = question.interrupts;
    instruction.silence_is_success = question.silence_is_success;
    instruction.may_stay_silent = question.may_be_silent;
    instruction.accepts = question.accepts;
    return instruction;
}

core::Duration readLimit(const GeodimeterState& state) {
    const auto initial = state.settings.read_limit / kReadPatience;
    const auto learned = kReadPatience * state.statistics.limit(kReadKey, initial, initial);
    return std::max(learned, state.settings.least_read_limit);
}

/// A syntax error in a question of ours was made on the way.
bool isDamagedQuestion(const Question& question, const protocol::Reply& reply) {
    constexpr int kSyntaxError = 30;
    const auto status = checkBlock(reply).status;
    return question.ours && status && status->code == kSyntaxError;
}

void judgeLine(GeodimeterState& state, const Question& question,
               const core::Result<protocol::Reply>& outcome) {
    const bool lost = !outcome && outcome.error().kind == core::ErrorKind::kTimeOut;
    const bool damaged = outcome && (checkBlock(*outcome).kind == BlockKind::kMalformed ||
                                     isDamagedQuestion(question, *outcome));
    const bool silent = lost && outcome.error().detail.isEmpty();
    state.silences_in_row = silent ? state.silences_in_row + 1 : 0;
    if (lost || damaged) {
        state.quality.trouble();
    } else if (outcome) {
        state.quality.clean();
    }
}

bool isWarned(const CheckedBlock& block) { return block.status && protocol::isWarning(block.status->code); }

/// The block, or what is wrong with the exchange.
core::Result<CheckedBlock> judged(core::Result<protocol::Reply> outcome, const Question& question) {
    if (!outcome) {
        return tl::unexpected(std::move(outcome).error());
    }
    auto block = checkBlock(*outcome);
    if (block.kind == BlockKind::kMalformed) {
        return tl::unexpected(damagedAnswer(*outcome));
    }
    const bool is_command = question.silence_is_success;
    if (auto error = is_command ? commandError(block) : deviceError(block)) {
        return tl::unexpected(*std::move(error));
    }
    return block;
}

bool isWorthRepeating(const core::Error& error, const Question& question) {
    const bool refused = isClass(error, InfoClass::kProtocol);
    return refused ? question.ours : isLineTrouble(error);
}

/// Whether it is asked again, as the `attempt`th repetition. `earlier_code`: of the answer before.
bool repeats(const GeodimeterState& state, const core::Error& error, const Question& question, int attempt,
             std::optional<int> earlier_code) {
    const bool refused = isClass(error, InfoClass::kProtocol);
    if (state.quality.isNoisy() && error.info_code) {
        // `30` that lost its zero reads `3`: where bytes are lost a code counts when it comes twice.
        return attempt < patience(state) && (error.info_code != earlier_code || (refused && question.ours));
    }
    return attempt < (refused ? 1 : patience(state)) && isWorthRepeating(error, question);
}

}  // namespace

Question labelQuestion(const GeodimeterState& state, int label) {
    return {.bytes = protocol::encode(protocol::ReadLabel{.label = label}),
            .limit = readLimit(state),
            .accepts = [label](const protocol::Reply& reply) { return canAnswerLabel(reply, label); }};
}

Question commandQuestion(const GeodimeterState& state, const protocol::Command& command) {
    const bool measures = std::holds_alternative<protocol::Trigger>(command);
    return {.bytes = protocol::encode(command),
            .limit = state.settings.write_limit,
            .accepts = measures ? canAnswerCommand : canAnswerWrite,
            .silence_is_success = true};
}

std::optional<core::Error> deviceError(const CheckedBlock& block) {
    const auto& status = block.status;
    if (!status || protocol::infoCode(status->code).info_class == InfoClass::kOk ||
        (isWarned(block) && block.kind == BlockKind::kItems)) {
        return std::nullopt;
    }
    auto error = protocol::errorFromStatus(*status);
    if (protocol::infoCode(status->code).info_class == InfoClass::kAbort) {
        error.kind = core::ErrorKind::kCancelled;  // 190: somebody broke it off, we or the operator
    }
    return error;
}

std::optional<core::Error> commandError(const CheckedBlock& block) {
    return isWarned(block) ? std::nullopt : deviceError(block);
}

bool isClass(const core::Error& error, InfoClass info_class) {
    return error.info_code && protocol::infoCode(*error.info_code).info_class == info_class;
}

bool isLineTrouble(const core::Error& error) {
    if (error.info_code) {
        return isClass(error, InfoClass::kComm) || isClass(error, InfoClass::kRetry) ||
               isClass(error, InfoClass::kProtocol);
    }
    return error.kind == core::ErrorKind::kTimeOut || error.kind == core::ErrorKind::kProtocol;
}

core::Task<core::Result<protocol::Reply>> exchange(StatePtr state, Question question, std::stop_token stop) {
    if (state->line == nullptr) {
        co_return core::cancelled();
    }
    const core::Duration asked_at = state->clock.now();
    const bool is_idle = state->line->isIdle();
    auto running = state->line->execute(instructionFor(*state, question), stop);
    auto outcome = co_await running;
    judgeLine(*state, question, outcome);
    if (outcome) {
        state->warnings.note(checkBlock(*outcome).status);
    }
    if (outcome && is_idle && question.bytes.starts_with("RG,")) {
        state->statistics.add(kReadKey, state->clock.now() - asked_at);
    }
    co_return outcome;
}

core::Task<bool> settleLine(StatePtr state, std::stop_token stop) {
    const int label = state->settling_label;
    const int silences_before = state->silences_in_row;
    for (int i = 0; i < kSettleAttempts && !stop.stop_requested(); ++i) {
        if (state->silences_in_row >= silences_before + kSilencesOfADeadLine) {
            break;
        }
        Question question = labelQuestion(*state, label);
        question.limit = kSettleLimit;
        question.accepts = [label](const protocol::Reply& reply) { return isExactlyLabel(reply, label); };
        auto asking = exchange(state, question, stop);
        const auto outcome = co_await asking;
        if (outcome && checkBlock(*outcome).kind == BlockKind::kItems) {
            co_return true;
        }
    }
    co_return false;
}

core::Task<core::Result<CheckedBlock>> ask(StatePtr state, Question question, std::stop_token stop) {
    std::optional<int> earlier_code;
    int silences = 0;
    for (int attempt = 0;; ++attempt) {
        auto asking = exchange(state, question, stop);
        auto outcome = judged(co_await asking, question);
        if (outcome || stop.stop_requested() ||
            !repeats(*state, outcome.error(), question, attempt, earlier_code)) {
            co_return outcome;
        }
        earlier_code = outcome.error().info_code;
        const bool refused = isClass(outcome.error(), InfoClass::kProtocol);
        qCDebug(core::logInstrument) << "asking again:" << question.bytes.c_str() << outcome.error().detail;
        if (isClass(outcome.error(), InfoClass::kRetry)) {
            auto pausing = core::sleepFor(state->clock, kBusyPause * (1 << std::min(attempt, 3)), stop);
            PMTS_CO_TRY(co_await pausing);
        }
        const bool unanswered = outcome.error().kind == core::ErrorKind::kTimeOut;
        silences = unanswered && outcome.error().detail.isEmpty() ? silences + 1 : 0;
        if (question.may_be_silent && silences > state->settings.retries) {
            co_return outcome;
        }
        if (unanswered || !refused) {
            auto settling = settleLine(state, stop);
            const bool is_settled = co_await settling;
            if (!is_settled && unanswered) {
                co_return outcome;
            }
        }
        question.limit = std::min(2 * question.limit, std::max(question.limit, state->settings.read_limit));
    }
}

}  // namespace pmts::instrument
