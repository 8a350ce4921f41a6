#pragma once

#include "pmts/instrument/instruction_runner.hpp"

#include <atomic>
#include <functional>
#include <map>
#include <memory>

namespace pmts::app {

struct DryRunOrder {
    protocol::TableRoutine routine;
    std::map<std::string, double> numbers;
    /// Commands that the simulated base does not know are answered with the first reply that the table expects.
    bool believes_table = false;
};

/// Runs a routine against a simulated base of its own, in virtual time: no line is touched, and it is over at once. Blocks;
/// for a pool thread. `cancelled` is looked at between the steps.
[[nodiscard]] core::Result<instrument::RoutineOutcome> dryRun(const DryRunOrder& order, const std::atomic<bool>& cancelled,
                                                              const std::function<void(const instrument::StepOutcome&)>& on_step);

}  // namespace pmts::app
