#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/core/task.hpp"
#include "pmts/core/video_gate.hpp"
#include "pmts/protocol/command.hpp"
#include "pmts/protocol/reply.hpp"
#include "pmts/transport/byte_link.hpp"

#include <functional>
#include <memory>
#include <stop_token>
#include <string>

namespace pmts::scheduler {

/// Who goes first when several wait. Stop overtakes everything, a stop may even be written into a running transaction.
enum class Priority { kStop, kCommand, kPoll };

/// One turn on the line: what is sent and how its end is recognised.
struct MicroInstruction {
    std::string bytes;  ///< CR included
    core::Duration time_limit = std::chrono::seconds(15);
    Priority priority = Priority::kCommand;
    bool time_critical = false;  ///< the video gate is closed from before sending until the reply or the time-out
    bool interrupts = false;     ///< write at once, even while another transaction waits for its block end (stop)
    bool expects_reply = true;   ///< false: done when written (PV,21)
    /// Form V was asked for.
    bool separate = false;
    /// Ends the transaction when this bare byte arrives instead of a block (`*` of a load command).
    char prompt = '\0';
};

/// What the time line and the statistics see of one transaction. Values, copied across threads.
struct TransactionRecord {
    std::string sent;
    std::string received;
    core::Duration queued_at{0};
    core::Duration sent_at{0};
    core::Duration finished_at{0};
    bool timed_out = false;
    bool video_paused = false;
};

/// One transaction at a time on one line (thesis ch. 8: one micro-instruction per turn). Lives on the instrument thread.
/// Every execute() is completed exactly once: by its reply, its time limit, its stop token, or the loss of the link.
class Scheduler {
public:
    Scheduler(transport::ByteLink& link, core::Clock& clock, core::VideoGate& gate);
    ~Scheduler();  ///< completes all waiters with kCancelled
    Scheduler(const Scheduler&) = delete;
    Scheduler& operator=(const Scheduler&) = delete;

    /// The reply, whatever its status: info codes are the driver's business. Fails with kTimeOut, kLinkLost, kCancelled.
    /// After a time-out or a cancel in mid-transaction the late reply is swallowed up to its block end (or a quiet
    /// time), so that it is never taken for the answer to the next instruction.
    [[nodiscard]] core::Task<core::Result<protocol::Reply>> execute(MicroInstruction instruction, std::stop_token stop = {});

    /// Completes every waiter with this error: unplugged, mode of control changed.
    void failAll(const core::Error& error);
    void setEndMark(std::optional<char> end_mark);
    [[nodiscard]] bool isIdle() const;

    /// Blocks nobody asked for: REG key and slave mode (protocol page 2.8).
    std::function<void(const protocol::Reply&)> on_unsolicited;
    std::function<void(const TransactionRecord&)> on_finished;
    /// The link was lost; all waiters have been completed before.
    std::function<void(const core::Error&)> on_lost;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::scheduler
