#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/core/task.hpp"
#include "pmts/protocol/instruction_table.hpp"
#include "pmts/scheduler/scheduler.hpp"

#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace pmts::instrument {

enum class StepVerdict {
    kExpected,
    kMissing,    ///< no reply, and the table says that there may be none
    kFailed,     ///< a reply that the table lists as a failure
    kUnknown,    ///< a reply that the table does not know: ends the routine as a failure does
    kTimedOut,
    kBrokenOff,  ///< cancelled, or the line was lost
};

/// One micro-instruction that has run.
struct StepOutcome {
    std::size_t index = 0;  ///< of the routine's steps
    int line = 0;           ///< of the table's file
    std::string sent;       ///< CR included
    std::string received;   ///< without its block end; empty where nothing came
    core::Duration sent_at{0};
    core::Duration finished_at{0};
    StepVerdict verdict = StepVerdict::kExpected;
    bool video_paused = false;
};

/// A routine that went well: every reply was an expected one, or missing where it may be.
struct RoutineOutcome {
    std::string routine;
    std::vector<StepOutcome> steps;
};

/// Runs routines of an instruction table on the bus, one micro-instruction per turn of the scheduler (protocol page 5.4).
/// Nothing is sent before every number is there and in range. The first reply that is not expected ends the routine;
/// steps marked `always` still run then. A cancel waits for the reply of the step on the wire, 2 s at the most.
/// Lives on the instrument thread.
class InstructionRunner {
public:
    /// Both outlive the runner and what it runs.
    InstructionRunner(scheduler::Scheduler& line, core::Clock& clock);
    ~InstructionRunner();  ///< a routine that runs goes on, nobody is told of its steps
    InstructionRunner(const InstructionRunner&) = delete;
    InstructionRunner& operator=(const InstructionRunner&) = delete;

    /// Fails with kBadInput (a number), kDevice (a reply that is an info code), kProtocol (another reply), kTimeOut,
    /// kCancelled, or as Scheduler::execute() does; what ran until then was told by on_step.
    [[nodiscard]] core::Task<core::Result<RoutineOutcome>> run(protocol::TableRoutine routine,
                                                               std::map<std::string, double> numbers, std::stop_token stop);

    std::function<void(std::size_t index)> on_begin;  ///< this step is queued for the line now
    std::function<void(const StepOutcome&)> on_step;  ///< each step when it has ended, well or not

private:
    class Impl;
    std::shared_ptr<Impl> impl_;
};

}  // namespace pmts::instrument
