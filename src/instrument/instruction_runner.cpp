#include "pmts/instrument/instruction_runner.hpp"

#include "pmts/core/logging.hpp"
#include "pmts/protocol/info_code.hpp"

namespace pmts::instrument {
namespace {

using protocol::TableStep;
using protocol::TableVerdict;

/// A cancel lets the base finish the process that it is in, so that it is not left half way.
constexpr core::Duration kCancelPatience = std::chrono::seconds(2);

QString shown(const std::string& text) { return QString::fromLatin1(QByteArray::fromStdString(text)).trimmed(); }

QString stepName(const protocol::TableRoutine& routine, std::size_t index, const std::string& bytes) {
    return QObject::tr("Step %1 of %2, %3").arg(index + 1).arg(shown(routine.name), shown(bytes));
}

/// Whether a block can be the answer to this command. A damaged block of the running stream is none; to a question an
/// item must have the label that was asked for.
bool canAnswer(const std::string& bytes, const protocol::Reply& reply) {
    if (reply.items.empty() || reply.status) {
        return true;
    }
    const auto comma = bytes.find(',');
    if (bytes.front() != 'R' || comma == std::string::npos) {
        return reply.raw.find('=') == std::string::npos;
    }
    const auto label = bytes.substr(comma + 1, bytes.find_first_not_of("0123456789", comma + 1) - comma - 1);
    return reply.raw.find(label + '=') != std::string::npos;
}

}  // namespace

class InstructionRunner::Impl {
public:
    using Self = std::shared_ptr<Impl>;

    Impl(scheduler::Scheduler& the_line, core::Clock& the_clock) : line(the_line), clock(the_clock) {}

    static core::Task<core::Result<RoutineOutcome>> run(Self self, protocol::TableRoutine routine,
                                                        std::map<std::string, double> numbers, std::stop_token stop) {
        std::vector<std::string> commands;
        for (const auto& step : routine.steps) {
            auto bytes = protocol::bytesOf(step, numbers);
            PMTS_CO_TRY(bytes);
            commands.push_back(*bytes);
        }
        RoutineOutcome outcome{.routine = routine.name, .steps = {}};
        std::optional<core::Error> trouble;
        for (std::size_t i = 0; i < routine.steps.size(); ++i) {
            if (!trouble && stop.stop_requested()) {
                trouble = core::cancelled().value();
            }
            if (trouble && (outcome.steps.empty() || !routine.steps[i].always || trouble->kind == core::ErrorKind::kLinkLost)) {
                continue;
            }
            auto stepping = runStep(self, i, routine, commands[i], trouble ? std::stop_token() : stop);
            auto ended = co_await stepping;
            outcome.steps.push_back(ended.step);
            if (ended.trouble && !trouble) {
                trouble = std::move(ended.trouble);
            }
        }
        self->missed.clear();
        if (trouble) {
            co_return tl::unexpected(*std::move(trouble));
        }
        co_return outcome;
    }

    struct Ended {
        StepOutcome step;
        std::optional<core::Error> trouble;
    };

    static core::Task<Ended> runStep(Self self, std::size_t index, protocol::TableRoutine routine, std::string bytes,
                                     std::stop_token stop) {
        const TableStep& step = routine.steps[index];
        std::stop_source give_up;
        core::Timer patience;
        const std::stop_callback on_stop(stop, [self, &give_up, &patience] {
            patience = self->clock.callAfter(kCancelPatience, [give_up] { std::stop_source(give_up).request_stop(); });
        });
        self->begin(index);
        const auto sent_at = std::make_shared<core::Duration>(self->clock.now());
        auto instruction = self->instructionFor(step, bytes, sent_at);
        auto asking = self->line.execute(std::move(instruction), give_up.get_token());
        const auto reply = co_await asking;
        Ended ended{.step = {.index = index,
                             .line = step.line,
                             .sent = bytes,
                             .received = reply ? reply->raw : std::string(),
                             .sent_at = *sent_at,
                             .finished_at = self->clock.now(),
                             .video_paused = step.time_critical},
                    .trouble = {}};
        self->conclude(ended, step, reply, stepName(routine, index, bytes));
        self->tell(ended.step);
        if (!ended.trouble && step.pause > core::Duration::zero()) {
            auto pausing = core::sleepFor(self->clock, step.pause, stop);
            const auto paused = co_await pausing;
            if (!paused) {
                ended.trouble = paused.error();
            }
        }
        co_return ended;
    }

    [[nodiscard]] scheduler::MicroInstruction instructionFor(const TableStep& step, const std::string& bytes,
                                                             const std::shared_ptr<core::Duration>& sent_at) const {
        scheduler::MicroInstruction instruction;
        instruction.bytes = bytes;
        instruction.time_limit = step.within;
        instruction.time_critical = step.time_critical;
        instruction.may_stay_silent = step.optional;
        instruction.on_sent = [sent_at](core::Duration at) { *sent_at = at; };
        instruction.accepts = [step, bytes, missed_ones = missed](const protocol::Reply& reply) {
            const bool is_late = protocol::judge(step, reply.raw) == TableVerdict::kUnknown &&
                                 std::ranges::any_of(missed_ones, [&](const TableStep& earlier) {
                                     return protocol::judge(earlier, reply.raw) != TableVerdict::kUnknown;
                                 });
            return !is_late && canAnswer(bytes, reply);
        };
        return instruction;
    }

    void conclude(Ended& ended, const TableStep& step, const core::Result<protocol::Reply>& reply, const QString& name) {
        auto& verdict = ended.step.verdict;
        if (!reply) {
            concludeWithoutReply(ended, step, reply.error(), name);
            return;
        }
        switch (protocol::judge(step, reply->raw)) {
            case TableVerdict::kExpected: return;
            case TableVerdict::kFailed: verdict = StepVerdict::kFailed; break;
            case TableVerdict::kUnknown: verdict = StepVerdict::kUnknown; break;
        }
        ended.trouble = errorOf(*reply, name);
    }

    void concludeWithoutReply(Ended& ended, const TableStep& step, const core::Error& error, const QString& name) {
        auto& verdict = ended.step.verdict;
        if (error.kind == core::ErrorKind::kTimeOut && step.optional) {
            verdict = StepVerdict::kMissing;
            missed.push_back(step);
            return;
        }
        ended.trouble = error;
        if (error.kind != core::ErrorKind::kTimeOut) {
            verdict = StepVerdict::kBrokenOff;
            return;
        }
        verdict = StepVerdict::kTimedOut;
        const double limit_s = std::chrono::duration<double>(step.within).count();
        ended.trouble->happened = QObject::tr("%1: no reply within %2 s.").arg(name).arg(limit_s);
    }

    static core::Error errorOf(const protocol::Reply& reply, const QString& name) {
        if (reply.status && !reply.damaged && reply.items.empty()) {
            auto error = protocol::errorFromStatus(*reply.status);
            error.kind = core::ErrorKind::kDevice;
            error.detail += QObject::tr("; the table says what this step expects");
            error.happened = QObject::tr("%1 was answered %2: %3").arg(name, shown(reply.raw), error.happened);
            return error;
        }
        return {.kind = core::ErrorKind::kProtocol,
                .happened = QObject::tr("%1 was answered \"%2\", which the table does not know.").arg(name, shown(reply.raw)),
                .remedy = QObject::tr("If the base means success by it, add it to the table's expected replies."),
                .info_code = std::nullopt,
                .detail = {}};
    }

    void begin(std::size_t index) const {
        if (owner != nullptr && owner->on_begin) {
            owner->on_begin(index);
        }
    }
    void tell(const StepOutcome& step) const {
        if (owner != nullptr && owner->on_step) {
            owner->on_step(step);
        }
    }

    scheduler::Scheduler& line;
    core::Clock& clock;
    InstructionRunner* owner = nullptr;
    std::vector<TableStep> missed;  ///< of this routine: their replies may come late
};

InstructionRunner::InstructionRunner(scheduler::Scheduler& line, core::Clock& clock)
    : impl_(std::make_shared<Impl>(line, clock)) {
    impl_->owner = this;
}

InstructionRunner::~InstructionRunner() { impl_->owner = nullptr; }

core::Task<core::Result<RoutineOutcome>> InstructionRunner::run(protocol::TableRoutine routine,
                                                                std::map<std::string, double> numbers, std::stop_token stop) {
    return Impl::run(impl_, std::move(routine), std::move(numbers), std::move(stop));
}

}  // namespace pmts::instrument
