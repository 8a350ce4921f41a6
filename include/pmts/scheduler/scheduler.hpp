#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/core/task.hpp"
#include "pmts/core/video_gate.hpp"
#include "pmts/protocol/reply.hpp"
#include "pmts/scheduler/control.hpp"
#include "pmts/transport/byte_link.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace pmts::scheduler {

/// Who goes first when several wait. Stop overtakes everything, a stop may even be written into a running
/// transaction.
enum class Priority { kStop, kCommand, kPoll };

/// Keeps the line over several instructions (a file on its way in), from others of PMTS and from a panel.
using Hold = std::shared_ptr<const int>;

/// One turn on the line: what is sent and how its end is recognised.
struct MicroInstruction {
    std::string bytes;  ///< CR included
    core::Duration time_limit = std::chrono::seconds(15);
    Priority priority = Priority::kCommand;
    bool time_critical =
        false;  ///< the video gate is closed from before sending until the reply or the time-out
    bool interrupts =
        false;  ///< write at once, even while another transaction waits for its block end (stop)
    bool expects_reply = true;  ///< false: done when written (PV,21)
    bool may_stay_silent = false;  ///< no reply in time is usual: told in the record, not counted as a time-out
    /// Form V was asked for.
    bool separate = false;
    /// Any of these bare bytes ends the transaction instead of a block: `*` of a load command, `@` and `!` of
    /// PV,20.
    std::string prompts{};
    /// Whether this block can be the answer at all; nothing set: any block. A block that cannot is a late or
    /// doubled reply, or one that nobody asked for, and the transaction waits on. Must take every status-only
    /// block.
    std::function<bool(const protocol::Reply&)> accepts{};
    /// Without block ends (label 79 = 0) silence is the answer to a successful write: then it ends with an
    /// empty reply.
    bool silence_is_success = false;
    /// Told when it is written, on the instrument thread: it may have waited for its turn.
    std::function<void(core::Duration at)> on_sent{};
    /// A long answer (a file): hears all that has come so far, and the time limit begins anew at each byte.
    std::function<void(std::string_view so_far)> growing{};
    /// From Scheduler::hold(): from its first instruction until the last copy is gone nothing else is sent.
    Hold hold{};
};

/// kSwallowed: a command of the panel that did not go to the instrument.
enum class Outcome { kAnswered, kTimedOut, kCancelled, kFailed, kSwallowed };

/// What the time line and the statistics see of one transaction. Values, copied across threads.
struct TransactionRecord {
    std::string sent;
    std::string received;  ///< after a time-out what had come until then, without a block end
    core::Duration queued_at{0};
    core::Duration sent_at{0};
    core::Duration finished_at{0};
    bool timed_out = false;
    bool video_paused = false;
    bool may_stay_silent = false;  ///< as the instruction said
    Priority priority = Priority::kCommand;
    Outcome outcome = Outcome::kAnswered;
    Master master = Master::kComputer;
};

/// Counts of what did not belong to a transaction: a healthy line has zeros here.
struct LineCounts {
    std::uint64_t late = 0;         ///< replies that came after their time-out or cancel, swallowed
    std::uint64_t doubled = 0;      ///< the last reply once more, dropped
    std::uint64_t unsolicited = 0;  ///< handed to on_unsolicited
    std::uint64_t noise = 0;        ///< blocks, or beginnings of blocks, that no grammar reads
    std::uint64_t timed_out = 0;
};

enum class StrayKind { kLate, kDoubled, kUnsolicited, kNoise };

/// What came and belongs to no transaction; the kinds are those of LineCounts.
struct Stray {
    StrayKind kind = StrayKind::kUnsolicited;
    std::string bytes;  ///< without the block end
    core::Duration at{0};
};

/// One transaction at a time on one line (thesis ch. 8: one micro-instruction per turn). Lives on the
/// instrument thread, as do its stop tokens. Every execute() is completed exactly once: by its reply, its
/// time limit, its stop token, or the loss of the link. An instruction is written inside execute() when the
/// line is idle: no timer, no event in between.
///
/// Whose answer a block is: the grammar has no numbers for that, so (1) blocks answer in the order of
/// writing; (2) a block that `accepts` refuses, or that is complete before the command can have left the wire
/// (setByteTime), is no answer; (3) after a time-out or cancel nothing is sent until the owed block has come
/// or the line was quiet for the quiet time. Left over: a doubled reply that looks exactly like the next
/// one's. It shifts the answers by one until the next instruction of another kind; a driver settles it by
/// reading an unmistakable label after every time-out.
class Scheduler {
public:
    /// All three outlive the scheduler. Takes the callbacks of the link.
    Scheduler(transport::ByteLink& link, core::Clock& clock, core::VideoGate& gate);
    ~Scheduler();  ///< completes all waiters with kCancelled
    Scheduler(const Scheduler&) = delete;
    Scheduler& operator=(const Scheduler&) = delete;

    /// The reply, whatever its status: info codes are the driver's business. Fails with kTimeOut, kLinkLost,
    /// kCancelled.
    [[nodiscard]] core::Task<core::Result<protocol::Reply>> execute(MicroInstruction instruction,
                                                                    std::stop_token stop = {});

    /// A stop (`interrupts`) is written all the same; a bar lets the instructions of a hold that runs pass.
    [[nodiscard]] Hold hold();

    /// Completes every waiter with this error: unplugged, mode of control changed. What is on the wire stays
    /// owed.
    void failAll(const core::Error& error);
    /// The same, and nothing is owed any more: the line begins anew (another port, another instrument).
    void reset(const core::Error& error);
    void setEndMark(std::optional<char> end_mark);
    [[nodiscard]] std::optional<char> endMark() const;
    /// How long the line must be silent to count as quiet; also the block end when there is no end mark.
    /// Default 500 ms.
    void setQuietTime(core::Duration quiet_time);
    /// How the running stream of the bus dialect begins, `A,`; empty (default): there is none. Its blocks answer nobody,
    /// go to on_stream and do not count as noise on a line that must be quiet.
    void setStreamHead(std::string head);
    /// Time of one byte on the wire, 0 (default) when unknown: replies faster than the wire are then not
    /// believed.
    void setByteTime(core::Duration byte_time);
    /// On a line that is shared: asked before each transaction, told after it. Null (default): the line is ours alone.
    /// A stop still goes at once into a transaction of our own; into one of the other side it does not.
    void setKeeper(LineKeeper* keeper);
    /// Nothing may be sent: what waits and what comes fails with this error; what is on the wire is finished, and may be
    /// stopped. nullopt: as usual again.
    void bar(std::optional<core::Error> reason);
    [[nodiscard]] bool isIdle() const;
    [[nodiscard]] LineCounts counts() const;

    /// Blocks nobody asked for: REG key and slave mode (protocol page 2.8).
    std::function<void(const protocol::Reply&)> on_unsolicited;
    std::function<void(const Stray&)> on_stray;  ///< those, and all others that answer nobody
    std::function<void(const TransactionRecord&)> on_finished;
    std::function<void(std::string_view block)> on_stream;  ///< without its block end
    /// The link was lost; all waiters have been completed before.
    std::function<void(const core::Error&)> on_lost;

private:
    class Impl;
    std::shared_ptr<Impl> impl_;  ///< shared with the transactions that are suspended
};

}  // namespace pmts::scheduler
