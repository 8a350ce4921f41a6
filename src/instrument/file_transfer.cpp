#include "file_transfer.hpp"

#include "pmts/protocol/memory_file.hpp"

#include <algorithm>
#include <charconv>
#include <map>

namespace pmts::instrument {
namespace {

constexpr int kMostReadings = 6;
constexpr std::size_t kLongestStatus = 2;  ///< of a free memory: fewer than a hundred bytes are as good as none

std::vector<std::string> linesOf(const std::string& raw) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < raw.size();) {
        const auto end = std::min(raw.find_first_of("\r\n", at), raw.size());
        if (end > at) {
            lines.push_back(raw.substr(at, end - at));
        }
        at = end + 1;
    }
    return lines;
}

std::optional<core::Error> statusError(const std::vector<std::string>& lines) {
    const auto status = lines.size() == 1 ? protocol::parseStatus(lines.front()) : std::nullopt;
    const bool fine = !status || protocol::isWarning(status->code) ||
                      protocol::infoCode(status->code).info_class == protocol::InfoClass::kOk;
    return fine ? std::nullopt : std::optional(protocol::errorFromStatus(*status));
}

core::Error noTwoAlike() {
    return {
        .kind = core::ErrorKind::kProtocol,
        .happened = QObject::tr("The file could not be read: of %1 readings no two were the same.").arg(kMostReadings),
        .remedy = QObject::tr("The line loses bytes: check cable and plugs, then repeat. Nothing was saved."),
        .info_code = std::nullopt,
        .detail = {}};
}

/// Trouble on the way, as a question that lost a byte is (30); the codes of files are the instrument's last word.
bool mayPass(const core::Error& error) {
    constexpr int kSyntax = 30;
    return error.info_code == kSyntax || isClass(error, protocol::InfoClass::kComm) ||
           isClass(error, protocol::InfoClass::kRetry);
}

int countLines(std::string_view text) { return static_cast<int>(std::ranges::count(text, '\n')); }

/// One block of whatever length, as its lines; a status that is an error is one here, too.
core::Task<core::Result<std::vector<std::string>>> askLines(StatePtr state, std::string bytes, OnTransfer progress,
                                                            TransferProgress step, std::stop_token stop) {
    if (state->line == nullptr) {
        co_return core::cancelled();
    }
    scheduler::MicroInstruction instruction;
    instruction.bytes = std::move(bytes);
    instruction.time_limit = state->settings.file_silence;
    instruction.growing = [progress, step](std::string_view so_far) mutable {
        const int lines = countLines(so_far);
        if (progress && lines != step.done) {
            step.done = lines;
            progress(step);
        }
    };
    auto running = state->line->execute(std::move(instruction), stop);
    const auto reply = co_await running;
    if (!reply) {
        co_return tl::unexpected(reply.error());
    }
    auto lines = linesOf(reply->raw);
    if (const auto error = statusError(lines)) {
        co_return tl::unexpected(*error);
    }
    if (progress) {
        step.done = static_cast<int>(lines.size());
        progress(step);
    }
    co_return lines;
}

/// The same question until two answers are the same.
core::Task<core::Result<DownloadedFile>> readAgreed(StatePtr state, std::string bytes, OnTransfer progress,
                                                    std::stop_token stop) {
    std::map<std::vector<std::string>, int> seen;
    std::optional<core::Error> earlier;
    TransferProgress step;
    for (int reading = 1; reading <= kMostReadings; ++reading) {
        auto settling = settleLine(state, stop);
        [[maybe_unused]] const bool settled = co_await settling;
        auto asking = askLines(state, bytes, progress, step, stop);
        auto lines = co_await asking;
        if (!lines) {
            const bool refused = lines.error().info_code && !mayPass(lines.error());
            const bool sure =
                refused && (!state->quality.isNoisy() || (earlier && earlier->info_code == lines.error().info_code));
            const bool lost = lines.error().kind != core::ErrorKind::kTimeOut && !lines.error().info_code;
            if (sure || lost || stop.stop_requested()) {
                co_return tl::unexpected(lines.error());
            }
            earlier = lines.error();
            state->quality.trouble();
            continue;
        }
        step = {.step = TransferStep::kComparing, .done = 0, .of = static_cast<int>(lines->size())};
        if (++seen[*lines] == 2) {
            co_return DownloadedFile{.id = {}, .lines = *lines, .readings = reading};
        }
        if (seen.size() > 1) {
            state->quality.trouble();
        }
    }
    co_return tl::unexpected(seen.empty() && earlier ? *earlier : noTwoAlike());
}

core::Task<core::Result<std::vector<MemoryFileId>>> listDirectory(StatePtr state, protocol::Directory directory,
                                                                  std::stop_token stop) {
    auto reading = readAgreed(state, protocol::encode(protocol::ListFiles{.directory = directory}), {}, stop);
    const auto listed = co_await reading;
    if (!listed) {
        co_return tl::unexpected(listed.error());
    }
    std::vector<MemoryFileId> files;
    for (const std::string& line : listed->lines) {
        const auto name = line.substr(std::min(line.find('=') + 1, line.size()));
        files.push_back({directory, QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()))});
    }
    co_return files;
}

/// A byte count has no `=`; a short one cannot be told from an info code.
std::optional<qint64> byteCount(const std::vector<std::string>& lines) {
    qint64 bytes = 0;
    const std::string text = lines.size() == 1 ? lines.front() : std::string();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bytes);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    const bool may_be_status = text.size() <= kLongestStatus && bytes != 0;
    return whole && !may_be_status ? std::optional(bytes) : std::nullopt;
}

core::Task<std::optional<qint64>> freeMemory(StatePtr state, std::stop_token stop) {
    scheduler::MicroInstruction instruction;
    instruction.bytes = protocol::encode(protocol::FreeMemory{});
    instruction.time_limit = state->settings.read_limit;
    auto running = state->line->execute(std::move(instruction), stop);
    const auto reply = co_await running;
    co_return reply ? byteCount(linesOf(reply->raw)) : std::nullopt;
}

core::Result<void> checkName(const MemoryFileId& id) {
    constexpr qsizetype kLongest = 15;
    const bool plain = std::ranges::all_of(id.name, [](QChar c) { return c > u' ' && c < u'\x7f' && c != u'='; });
    if (!id.name.isEmpty() && id.name.size() <= kLongest && plain) {
        return {};
    }
    return core::fail(core::ErrorKind::kBadInput, QObject::tr("“%1” is no file name for the instrument.").arg(id.name),
                      QObject::tr("1 to 15 plain characters without blanks; case counts."));
}

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
    if (!listening.isReady()) {
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
    opening.accepts = [](const protocol::Reply& reply) { return answersLoad(reply) || reply.raw.starts_with('*'); };
    auto asking = state->line->execute(std::move(opening), {});
    const auto ready = co_await asking;
    if (!ready) {
        auto ending = endBlindly(state, hold, end_mark);
        co_await ending;
        co_return tl::unexpected(ready.error().kind == core::ErrorKind::kTimeOut ? notReady(id) : ready.error());
    }
    if (!ready->raw.starts_with('*')) {
        co_return tl::unexpected(deviceError(checkBlock(*ready)).value_or(notReady(id)));
    }
    // Whether a line end or block end follows the `*` is not stated: it passes before anybody listens for the end.
    auto pausing = core::sleepFor(state->clock, state->settings.file_prompt_pause, {});
    [[maybe_unused]] const auto paused = co_await pausing;
    auto sending = sendLines(state, id, std::move(lines), hold, end_mark, progress, stop);
    co_return co_await sending;
}

}  // namespace

core::Task<core::Result<MemoryListing>> listMemory(StatePtr state, std::stop_token stop) {
    if (const auto refused = refusal(*state, false)) {
        co_return tl::unexpected(*refused);
    }
    const Routine routine(state, Activity::kReading, stop, std::nullopt);
    MemoryListing listing;
    for (const auto directory : {protocol::Directory::kJob, protocol::Directory::kArea}) {
        auto reading = listDirectory(state, directory, routine.token());
        const auto files = co_await reading;
        if (!files) {
            co_return tl::unexpected(files.error());
        }
        listing.files.insert(listing.files.end(), files->begin(), files->end());
    }
    auto asking = freeMemory(state, routine.token());
    listing.free_bytes = co_await asking;
    co_return listing;
}

core::Task<core::Result<DownloadedFile>> downloadFile(StatePtr state, MemoryFileId id, OnTransfer progress,
                                                      std::stop_token stop) {
    if (const auto refused = refusal(*state, false)) {
        co_return tl::unexpected(*refused);
    }
    if (const auto named = checkName(id); !named) {
        co_return tl::unexpected(named.error());
    }
    const Routine routine(state, Activity::kReading, stop, std::nullopt);
    const protocol::Command command =
        protocol::OutputFile{.directory = id.directory, .name = id.name.toStdString(), .via_protocol = {}};
    auto reading = readAgreed(state, protocol::encode(command), progress, routine.token());
    auto file = co_await reading;
    if (file) {
        file->id = id;
    }
    co_return file;
}

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
    const protocol::Command command =
        protocol::OutputFile{.directory = id.directory, .name = id.name.toStdString(), .via_protocol = {}};
    OnTransfer back = [progress, of = *sent](const TransferProgress& step) {
        if (progress) {
            progress({.step = TransferStep::kReadingBack, .done = step.done, .of = of});
        }
    };
    auto reading = readAgreed(state, protocol::encode(command), back, routine.token());
    const auto kept = co_await reading;
    if (!kept) {
        co_return tl::unexpected(kept.error());
    }
    uploaded.kept = kept->lines;
    co_return uploaded;
}

}  // namespace pmts::instrument
