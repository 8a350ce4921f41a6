#pragma once

namespace pmts::core {

/// Asks the system to run the calling thread before all ordinary ones as soon as it has something to do: for the thread
/// that stands between an instrument and its panel, and never does anything slow. False where the system does not allow it
/// (on Linux the user needs a real-time limit, `ulimit -r`, above 0); the thread then runs as before.
bool makeThisThreadPrompt();

}  // namespace pmts::core
