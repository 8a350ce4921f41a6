#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"
#include "pmts/simulator/control_unit.hpp"
#include "pmts/simulator/station.hpp"

#include <QString>
#include <QStringList>

#include <functional>
#include <memory>

namespace pmts::simulator {

struct SimulationSettings {
    StationSettings station;
    QString scene_path;  ///< a scene file or a built-in name (Scene::named); empty: the town square
    QString link_path;   ///< a symbolic link to the pty; empty: none
    QString panel_link_path;  ///< a link to a second pty with a control unit behind it; empty: none
    QStringList faults;       ///< ordered before the first byte
};

/// A whole simulated instrument: scene, true pointing and station, served on a pty. Lives on one thread with
/// an event loop, the one that starts it; only pointing() and scene() may be handed to other threads (the
/// camera's).
class Simulation {
public:
    /// Fails with kBadInput (settings, faults), kFile (scene) or kPortUnavailable (no pty, link not
    /// possible).
    [[nodiscard]] static core::Result<std::unique_ptr<Simulation>> start(SimulationSettings settings,
                                                                         core::Clock& clock);
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    [[nodiscard]] QString slaveName() const;  ///< `/dev/pts/3`; empty while unplugged
    /// The port for a program that passes the control unit on to the instrument; empty without one.
    [[nodiscard]] QString panelSlaveName() const;
    [[nodiscard]] ControlUnit* controlUnit();  ///< null without one
    /// Puts a control unit behind a second pty, if there is none yet, and switches it on; the name of the pty.
    [[nodiscard]] core::Result<QString> plugPanel(QString link_path = {});
    void unplugPanel();
    [[nodiscard]] std::shared_ptr<TruePointing> pointing() const;
    [[nodiscard]] std::shared_ptr<const Scene> scene() const;
    [[nodiscard]] Station& station();
    [[nodiscard]] core::Result<void> injectFault(const QString& fault);

    void unplug();  ///< the pty goes away; the instrument stays on
    /// It is back, under another name while somebody still holds the old one.
    [[nodiscard]] core::Result<void> replug();
    std::function<void(const QString& slave_name)> on_replugged;  ///< also after the fault `unplug`

private:
    class Impl;
    explicit Simulation(std::unique_ptr<Impl> impl);
    void cancelTimers();

    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::simulator
