#pragma once

#include "pmts/core/result.hpp"
#include "pmts/simulator/bus_simulation.hpp"
#include "pmts/simulator/simulation.hpp"

#include <QStringList>

#include <optional>

namespace pmts::sim {

/// What the user asked for: an instrument, or a text to read.
struct Request {
    simulator::SimulationSettings settings;
    std::optional<simulator::BusSimulationSettings> bus{};  ///< instead: the base on its bus
    std::optional<QString> text{};  ///< help, version or the list of faults: print and leave
};

/// `arguments` begins with the program's name. Fails with kBadInput in a sentence that names the argument.
[[nodiscard]] core::Result<Request> readCommandLine(const QStringList& arguments);

}  // namespace pmts::sim
