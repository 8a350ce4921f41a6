#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/simulator/bus_station.hpp"

#include <QString>
#include <QStringList>

#include <functional>
#include <memory>

namespace pmts::simulator {

struct BusSimulationSettings {
    BusStationSettings station;
    geometry::Pointing pointing{.ha = core::Angle::fromGon(177.56115),  ///< as the published capture
                                .va = core::Angle::fromGon(96.16838)};
    QString link_path;   ///< a symbolic link to the pty; empty: none
    QStringList faults;  ///< ordered before the first byte
};

/// A simulated base on its bus, served on a pty. Lives on one thread with an event loop.
class BusSimulation {
public:
    /// Fails with kBadInput (settings, faults) or kPortUnavailable (no pty, link not possible).
    [[nodiscard]] static core::Result<std::unique_ptr<BusSimulation>> start(BusSimulationSettings settings,
                                                                            core::Clock& clock);
    ~BusSimulation();
    BusSimulation(const BusSimulation&) = delete;
    BusSimulation& operator=(const BusSimulation&) = delete;

    [[nodiscard]] QString slaveName() const;
    [[nodiscard]] BusStation& station();
    std::function<void(const QString& slave_name)> on_replugged;  ///< after the fault `unplug`

private:
    class Impl;
    explicit BusSimulation(std::unique_ptr<Impl> impl);

    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::simulator
