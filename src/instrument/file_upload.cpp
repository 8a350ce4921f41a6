#include "file_reading.hpp"
#include "file_transfer.hpp"

#include "pmts/protocol/memory_file.hpp"

#include <algorithm>

namespace pmts::instrument {
namespace {

/// What would end the file early or arrive as something else.
core::Result<void> checkLines(const std::vector<std::string>& lines, char end_mark) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto parsed = protocol::parseMemoryFile(lines[i]);
        const bool plain = std::ranges::all_of(lines[i], [&](char c) { return c >= 0x20 && c <= 0x7E && c != end_mark; });
        if (!plain || !parsed.bad.empty() || parsed.lines.size() != 1) {
            return core::fail(
                core::ErrorKind::kBadInput,
                QObject::tr("Line %1 cannot be sent: it is no plain label=data, or holds the end mark “%2”.")
                    .arg(i + 1)
                    .arg(QLatin1Char(end_mark)),
                QObject::tr("Correct the line; nothing was sent."), QString::fromStdString(lines[i]));
        }
    }
    return {};
}

/// Marks that what is written becomes part of a file: a stop is not sent then.
class Loading {
public:
    explicit Loading(StatePtr state) : state_(std::move(state)) { state_->loading_file = true; }
    ~Loading() { state_->loading_file = false; }
    Loading(const Loading&) = delete;
    Loading& operator=(const Loading&) = delete;

private:
    StatePtr state_;
};

bool answersLoad(const protocol::Reply& reply) {
    const auto kind = checkBlock(reply).kind;
    return kind == BlockKind::kStatus || kind == BlockKind::kEmpty;
}

scheduler::MicroInstruction held(const scheduler::Hold& hold, std::string bytes, core::Duration limit) {
    scheduler::MicroInstruction instruction;
    instruction.bytes = std::move(bytes);
    instruction.time_limit = limit;
    instruction.accepts = answersLoad;
    instruction.hold = hold;
    return instruction;
}

/// Into the transaction that listens for the end.
scheduler::MicroInstruction fileBytes(const scheduler::Hold& hold, std::string bytes) {
    auto instruction = held(hold, std::move(bytes), core::Duration::zero());
    instruction.expects_reply = false;
    instruction.interrupts = true;
    return instruction;
}

core::Error notReady(const MemoryFileId& id) {
    return {
        .kind = core::ErrorKind::kTimeOut,
        .happened = QObject::tr("The instrument did not say that it is ready for %1.").arg(id.name),
        .remedy =
            QObject::tr("List its files: an empty %1 may be there. Then send it again under another name.").arg(id.name),
        .info_code = std::nullopt,
        .detail = {}};
}

core::Error noEnd(const MemoryFileId& id) {
    return {.kind = core::ErrorKind::kTimeOut,
            .happened = QObject::tr("The instrument did not confirm the end of %1.").arg(id.name),
            .remedy = QObject::tr("List its files and read %1 back before you rely on it.").arg(id.name),
            .info_code = std::nullopt,
            .detail = {}};
}

/// The end mark once more, for a load that may still wait for it; as a command it is only a syntax error.
core::Task<void> endBlindly(StatePtr state, scheduler::Hold hold, char end_mark) {
    if (state->line != nullptr) {
        auto ending = state->line->execute(held(hold, {end_mark, '\r'}, state->settings.write_limit), {});
        [[maybe_unused]] const auto ended = co_await ending;
    }
}

core::Error earlyEnd(int sent, std::size_t of) {
    return {.kind = core::ErrorKind::kProtocol,
            .happened =
                QObject::tr("The instrument answered after line %1 of %2, before the end of the file.").arg(sent).arg(of),
            .remedy = QObject::tr("It may hold a part of the file: look at its list, then send it under another name."),
            .info_code = std::nullopt,
            .detail = {}};
}

/// Nothing, or the error that the instrument said. Sends until the end, Cancel, or an answer before its time.
core::Task<core::Result<int>> sendLines(StatePtr state, MemoryFileId id, std::vector<std::string> lines,
                                        scheduler::Hold hold, char end_mark, OnTransfer progress, std::stop_token stop) {
    const auto patience = state->settings.file_silence + state->settings.file_silence;
    std::size_t bytes = 0;
    for (const std::string& line : lines) {
        bytes += line.size() + 2;
    }
    const auto wire_time = state->settings.file_byte_time * static_cast<std::int64_t>(bytes);
    auto listening = state->line->execute(held(hold, {}, 2 * wire_time + patience), {});
    int sent = 0;
    for (const std::string& line : lines) {
        if (listening.isReady() || stop.stop_requested() || state->line == nullptr) {
            break;
        }
        auto writing = state->line->execute(fileBytes(hold, line + "\r\n"), {});
        PMTS_CO_TRY(co_await writing);
        auto pacing = core::sleepFor(state->clock,
                                     state->settings.file_byte_time * static_cast<std::int64_t>(line.size() + 2), stop);
        [[maybe_unused]] const auto paced = co_await pacing;
        ++sent;
        if (progress) {
            progress({.step = TransferStep::kSending, .done = sent, .of = static_cast<int>(lines.size())});
        }
    }
    if (state->line == nullptr) {
        co_return core::cancelled();
    }
    const bool answered_early = listening.isReady();
    if (!answered_early) {
        auto ending = state->line->execute(fileBytes(hold, std::string(1, end_mark)), {});
        PMTS_CO_TRY(co_await ending);
    }
    const auto reply = co_await listening;
    if (!reply) {
        const bool silent = reply.error().kind == core::ErrorKind::kTimeOut;
        auto ending = endBlindly(state, hold, end_mark);
        co_await ending;
        co_return tl::unexpected(silent ? noEnd(id) : reply.error());
    }
    if (const auto error = deviceError(checkBlock(*reply))) {
        co_return tl::unexpected(*error);
    }
    if (answered_early) {  // noise that looked like an end: the file is still open
        auto ending = endBlindly(state, hold, end_mark);
        co_await ending;
        if (!stop.stop_requested()) {
            co_return tl::unexpected(earlyEnd(sent, lines.size()));
        }
    }
    co_return sent;
}

core::Task<core::Result<int>> load(StatePtr state, MemoryFileId id, std::vector<std::string> lines, OnTransfer progress,
                                   std::stop_token stop) {
    const char end_mark = *state->line->endMark();
    const auto hold = state->line->hold();
    const Loading loading(state);
    const protocol::Command command =
        protocol::LoadFile{.directory = id.directory, .name = id.name.toStdString(), .via_protocol = {}};
    auto opening = held(hold, protocol::encode(command), state->settings.file_silence);
    opening.prompts = "*";
    opening.accepts = [](const protocol::Reply& reply) {  // a bare block end is noise: the `*` is still to come
        return checkBlock(reply).kind == BlockKind::kStatus || reply.raw.starts_with('*');
    };
    auto asking = state->line->execute(std::move(opening), {});
    const auto ready = co_await asking;
    if (!ready) {
        auto ending = endBlindly(state, hold, end_mark);
        co_await ending;
        co_return tl::unexpected(ready.error().kind == core::ErrorKind::kTimeOut ? notReady(id) : ready.error());
    }
    if (!ready->raw.starts_with('*')) {
        if (const auto error = deviceError(checkBlock(*ready))) {
            co_return tl::unexpected(*error);
        }
        auto ending = endBlindly(state, hold, end_mark);  // no refusal: it may be open all the same
        co_await ending;
        co_return tl::unexpected(notReady(id));
    }
    // Whether a line end or block end follows the `*` is not stated: it passes before anybody listens for the end.
    auto pausing = core::sleepFor(state->clock, state->settings.file_prompt_pause, {});
    [[maybe_unused]] const auto paused = co_await pausing;
    auto sending = sendLines(state, id, std::move(lines), hold, end_mark, progress, stop);
    co_return co_await sending;
}

}  // namespace

core::Task<core::Result<UploadedFile>> uploadFile(StatePtr state, MemoryFileId id, std::vector<std::string> lines,
                                                  OnTransfer progress, std::stop_token stop) {
    if (const auto refused = refusal(*state, false)) {
        co_return tl::unexpected(*refused);
    }
    const auto end_mark = state->line->endMark();
    if (!end_mark) {
        co_return core::fail(core::ErrorKind::kUnsupported,
                             QObject::tr("The instrument has no end mark: it would not know where a file ends."),
                             QObject::tr("Set label 79 to 62 at the control unit, then connect again."));
    }
    const auto named = checkName(id);
    const auto plain = checkLines(lines, *end_mark);
    if (!named || !plain) {
        co_return tl::unexpected(named ? plain.error() : named.error());
    }
    const Routine routine(state, Activity::kReading, stop, std::nullopt);
    auto settling = settleLine(state, routine.token());
    [[maybe_unused]] const bool settled = co_await settling;
    if (state->line == nullptr || routine.token().stop_requested()) {
        co_return core::cancelled();
    }
    auto loading = load(state, id, lines, progress, routine.token());
    const auto sent = co_await loading;
    if (!sent) {
        co_return tl::unexpected(sent.error());
    }
    UploadedFile uploaded{.id = id, .sent_lines = *sent, .cancelled = *sent < static_cast<int>(lines.size()), .kept = {}};
    if (uploaded.cancelled || routine.token().stop_requested()) {
        uploaded.cancelled = true;
        co_return uploaded;
    }
    OnTransfer back = [progress, of = *sent](const TransferProgress& step) {
        if (progress) {
            progress({.step = TransferStep::kReadingBack, .done = step.done, .of = of});
        }
    };
    auto reading = readFile(state, id, lines, back, routine.token());
    const auto kept = co_await reading;
    if (!kept) {
        co_return tl::unexpected(kept.error());
    }
    uploaded.kept = kept->lines;
    co_return uploaded;
}

}  // namespace pmts::instrument
