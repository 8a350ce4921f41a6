#include "file_reading.hpp"
#include "file_transfer.hpp"

#include "pmts/protocol/labels.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

namespace pmts::instrument {
namespace {

constexpr int kMostReadings = 6;
constexpr int kJobLabel = 50, kAreaLabel = 15;  ///< of the names in a directory
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

using Accepts = std::function<bool(const protocol::Reply&)>;

/// The one label of all lines of a directory; a status answers, too.
bool canBeListing(const protocol::Reply& reply, int label) {
    const auto start = std::to_string(label) + '=';
    const auto kind = checkBlock(reply).kind;
    return kind == BlockKind::kStatus || kind == BlockKind::kEmpty ||
           std::ranges::all_of(linesOf(reply.raw), [&](const std::string& line) {
               return line.compare(std::min(line.find_first_not_of('>'), line.size()), start.size(), start) == 0;
           });
}

/// What the instrument says by itself with output by REG key, slave or tracking: angles, distance, coordinates, each once.
bool isBlockOfReadings(const protocol::Reply& reply) {
    constexpr std::array kReadings{protocol::kHa,       protocol::kVa,      protocol::kSd,
                                   protocol::kNorthing, protocol::kEasting, protocol::kElevation};
    const auto block = checkBlock(reply);
    return block.kind == BlockKind::kItems && std::ranges::all_of(block.items, [&](const protocol::Item& item) {
               return std::ranges::find(kReadings, item.label.value_or(-1)) != kReadings.end();
           });
}

core::Error readingsInstead() {
    return {.kind = core::ErrorKind::kProtocol,
            .happened = QObject::tr("The instrument sent readings of its own, and no file."),
            .remedy = QObject::tr("Its output is set to REG key, slave or tracking: set it to request at the control unit, "
                                  "then repeat. A file of one reading and nothing else cannot be told from those."),
            .info_code = std::nullopt,
            .detail = {}};
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
core::Task<core::Result<std::vector<std::string>>> askLines(StatePtr state, std::string bytes, Accepts accepts,
                                                            OnTransfer progress, TransferProgress step,
                                                            std::stop_token stop) {
    if (state->line == nullptr) {
        co_return core::cancelled();
    }
    scheduler::MicroInstruction instruction;
    instruction.bytes = std::move(bytes);
    instruction.time_limit = state->settings.file_silence;
    instruction.accepts = std::move(accepts);
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
core::Task<core::Result<DownloadedFile>> readAgreed(StatePtr state, std::string bytes, Accepts accepts,
                                                    OnTransfer progress, std::stop_token stop) {
    std::map<std::vector<std::string>, int> seen;
    std::optional<core::Error> earlier;
    TransferProgress step;
    for (int reading = 1; reading <= kMostReadings; ++reading) {
        auto settling = settleLine(state, stop);
        [[maybe_unused]] const bool settled = co_await settling;
        auto asking = askLines(state, bytes, accepts, progress, step, stop);
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
    const int label = directory == protocol::Directory::kArea ? kAreaLabel : kJobLabel;
    const Accepts accepts = [label](const protocol::Reply& reply) { return canBeListing(reply, label); };
    auto reading = readAgreed(state, protocol::encode(protocol::ListFiles{.directory = directory}), accepts, {}, stop);
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

}  // namespace

core::Result<void> checkName(const MemoryFileId& id) {
    constexpr qsizetype kLongest = 15;
    const bool plain = std::ranges::all_of(id.name, [](QChar c) { return c > u' ' && c < u'\x7f' && c != u'='; });
    if (!id.name.isEmpty() && id.name.size() <= kLongest && plain) {
        return {};
    }
    return core::fail(core::ErrorKind::kBadInput, QObject::tr("“%1” is no file name for the instrument.").arg(id.name),
                      QObject::tr("1 to 15 plain characters without blanks; case counts."));
}

core::Task<core::Result<DownloadedFile>> readFile(StatePtr state, MemoryFileId id, std::vector<std::string> expected,
                                                  OnTransfer progress, std::stop_token stop) {
    const protocol::Command command =
        protocol::OutputFile{.directory = id.directory, .name = id.name.toStdString(), .via_protocol = {}};
    const auto refused = std::make_shared<bool>(false);
    const Accepts accepts = [refused, expected](const protocol::Reply& reply) {
        const bool foreign = isBlockOfReadings(reply) && linesOf(reply.raw) != expected;
        *refused = *refused || foreign;
        return !foreign;
    };
    auto reading = readAgreed(state, protocol::encode(command), accepts, progress, stop);
    auto file = co_await reading;
    if (!file && file.error().kind == core::ErrorKind::kTimeOut && *refused) {
        co_return tl::unexpected(readingsInstead());
    }
    if (file) {
        file->id = id;
    }
    co_return file;
}

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
    auto reading = readFile(state, id, {}, progress, routine.token());
    co_return co_await reading;
}

}  // namespace pmts::instrument
