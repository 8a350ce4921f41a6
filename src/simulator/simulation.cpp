#include "pmts/simulator/simulation.hpp"

#include "pmts/core/logging.hpp"
#include "pmts/transport/pty_link.hpp"

namespace pmts::simulator {
namespace {

core::Result<Scene> sceneFor(const SimulationSettings& settings) {
    return Scene::named(settings.scene_path, settings.station.seed);
}

ControlUnitSettings unitFor(const StationSettings& station) {
    ControlUnitSettings unit;
    unit.seed = station.seed;
    unit.time_scale = station.time_scale;
    unit.baud = station.baud;
    unit.end_mark = station.end_mark;
    unit.serial_number = station.serial_number;
    return unit;
}

/// A control unit and its end of the cable.
struct PanelCable {
    PanelCable(const SimulationSettings& settings, core::Clock& clock)
        : link(settings.panel_link_path), unit(unitFor(settings.station), clock) {
        link.on_received = [this](std::string_view bytes) { unit.receive(bytes); };
        unit.send = [this](std::string_view bytes) { link.write(bytes); };
        unit.is_plugged = [this] { return link.hasClient(); };
    }

    transport::PtyLink link;
    ControlUnit unit;
};

}  // namespace

class Simulation::Impl {
public:
    Impl(const SimulationSettings& settings, Scene built, core::Clock& the_clock)
        : clock(the_clock),
          scene(std::make_shared<const Scene>(std::move(built))),
          link(settings.link_path),
          station(settings.station, scene, pointing, the_clock) {
        link.on_received = [this](std::string_view bytes) { station.receive(bytes); };
        station.send = [this](std::string_view bytes) { link.write(bytes); };
        if (!settings.panel_link_path.isEmpty()) {
            panel.emplace(settings, the_clock);
        }
    }

    core::Clock& clock;
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<TruePointing> pointing = std::make_shared<TruePointing>();
    transport::PtyLink link;
    Station station;
    std::optional<PanelCable> panel;
    core::Timer unplug_timer, replug_timer;
};

core::Result<std::unique_ptr<Simulation>> Simulation::start(SimulationSettings settings, core::Clock& clock) {
    PMTS_TRY(checkSettings(settings.station));
    auto scene = sceneFor(settings);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    std::unique_ptr<Simulation> simulation(
        new Simulation(std::make_unique<Impl>(settings, *std::move(scene), clock)));
    PMTS_TRY(simulation->impl_->link.open());
    if (auto& panel = simulation->impl_->panel) {
        PMTS_TRY(panel->link.open());
        panel->unit.start();
    }
    for (const QString& fault : std::as_const(settings.faults)) {
        PMTS_TRY(simulation->injectFault(fault));
    }
    return simulation;
}

Simulation::Simulation(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {
    impl_->station.on_unplug = [this](core::Duration span) {
        // Not at once: the fault may have been ordered while the link is handing out bytes.
        impl_->unplug_timer = impl_->clock.callAfter({}, [this] { impl_->link.close(); });
        impl_->replug_timer = impl_->clock.callAfter(span, [this] {
            if (const auto back = replug(); !back) {
                qCWarning(core::logSimulator) << "the pty did not come back:" << back.error().sentence();
            }
        });
    };
}

Simulation::~Simulation() = default;

void Simulation::cancelTimers() {
    impl_->unplug_timer.cancel();
    impl_->replug_timer.cancel();
}

QString Simulation::slaveName() const { return impl_->link.slaveName(); }
QString Simulation::panelSlaveName() const { return impl_->panel ? impl_->panel->link.slaveName() : QString(); }
ControlUnit* Simulation::controlUnit() { return impl_->panel ? &impl_->panel->unit : nullptr; }
std::shared_ptr<TruePointing> Simulation::pointing() const { return impl_->pointing; }
std::shared_ptr<const Scene> Simulation::scene() const { return impl_->scene; }
Station& Simulation::station() { return impl_->station; }
core::Result<void> Simulation::injectFault(const QString& fault) { return impl_->station.injectFault(fault); }

void Simulation::unplug() {
    cancelTimers();
    impl_->link.close();
}

core::Result<void> Simulation::replug() {
    cancelTimers();
    if (impl_->link.isOpen()) {
        return {};
    }
    PMTS_TRY(impl_->link.open());
    if (on_replugged) {
        on_replugged(slaveName());
    }
    return {};
}

}  // namespace pmts::simulator
