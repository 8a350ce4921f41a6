#pragma once

#include "exchange.hpp"
#include "pmts/instrument/memory.hpp"

namespace pmts::instrument {

/// PV,20: the instrument measures its compensator in both faces and turns by itself. `@`: it is being displayed;
/// `!`: it waits for yes or no, `on_question` makes the answer. The line is held until its end.
[[nodiscard]] core::Task<core::Result<CompensatorRun>> calibrateCompensator(
    StatePtr state, std::function<core::Completion<bool>()> on_question, std::stop_token stop);

}  // namespace pmts::instrument
