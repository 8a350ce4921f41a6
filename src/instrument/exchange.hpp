#pragma once

#include "block_check.hpp"
#include "geodimeter_state.hpp"
#include "pmts/protocol/command.hpp"

#include <functional>
#include <string>

namespace pmts::instrument {

/// One question to the instrument.
struct Question {
    std::string bytes;
    core::Duration limit{0};
    std::function<bool(const protocol::Reply&)> accepts{};
    scheduler::Priority priority = scheduler::Priority::kCommand;
    bool silence_is_success = false;
    bool interrupts = false;
    bool ours =
        true;  ///< known to be right: a syntax error then is a byte lost on the way, and it is asked again
    /// There may be no answer to it at all: total silence counts when it comes more often than `retries`, on a line that
    /// answers other questions, however noisy it is.
    bool may_be_silent = false;
};

[[nodiscard]] Question labelQuestion(const GeodimeterState& state, int label);
[[nodiscard]] Question commandQuestion(const GeodimeterState& state, const protocol::Command& command);

/// A status that is no success, as an error. A warning (protocol::isWarning) that comes with data is none.
[[nodiscard]] std::optional<core::Error> deviceError(const CheckedBlock& block);
/// The same for a command: a warning does not say that it was refused, and what matters is verified afterwards.
[[nodiscard]] std::optional<core::Error> commandError(const CheckedBlock& block);
[[nodiscard]] bool isClass(const core::Error& error, protocol::InfoClass info_class);
/// Trouble of the line and not of the instrument: lost answers, comm and retry class, refused questions of
/// ours.
[[nodiscard]] bool isLineTrouble(const core::Error& error);

/// Asks once. Any status is a value here; fails with kTimeOut, kCancelled, kLinkLost, kNotConnected.
[[nodiscard]] core::Task<core::Result<protocol::Reply>> exchange(StatePtr state, Question question,
                                                                 std::stop_token stop);

/// Reads a label until exactly that comes: then nothing is owed any more and later answers belong to their
/// questions. False when the instrument stays silent.
[[nodiscard]] core::Task<bool> settleLine(StatePtr state, std::stop_token stop);

/// Asks with the retry policy of protocol page 2.10: lost answers, comm and retry class up to `retries`
/// times, after the line has settled; everything else goes up unchanged. Success is any status of class ok,
/// or none.
[[nodiscard]] core::Task<core::Result<CheckedBlock>> ask(StatePtr state, Question question,
                                                         std::stop_token stop);

}  // namespace pmts::instrument
