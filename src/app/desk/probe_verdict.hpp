#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/instrument/line_probe.hpp"

namespace pmts::app {

/// What a search has come to, in one sentence, and what to do in another.
[[nodiscard]] StatusItem probeVerdict(const instrument::ProbeOutcome& outcome);

}  // namespace pmts::app
