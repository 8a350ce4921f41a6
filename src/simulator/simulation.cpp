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

/// A pty shows speed, stop bits and odd parity; what it hides is as the instrument has it.
LineFraming clientFraming(const transport::PtyClientLine& client, const LineFraming& own) {
    LineFraming line = own;
    line.baud = client.baud;
    line.stop_bits = client.two_stop_bits ? 2 : 1;
    if (client.odd_parity) {
        line.parity = WireParity::kOdd;
    } else if (own.parity == WireParity::kOdd) {
        line.parity = WireParity::kNone;
        line.data_bits = 8;
    }
    return line;
}

/// A control unit and its end of the cable.
struct PanelCable {
    PanelCable(const QString& link_path, const StationSettings& station, core::Clock& clock)
        : link(link_path), unit(unitFor(station), clock) {
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
          station_settings(settings.station),
          scene(std::make_shared<const Scene>(std::move(built))),
          link(settings.link_path),
          station(settings.station, scene, pointing, the_clock) {
        link.on_received = [this](std::string_view bytes) { station.receive(onTheWire(bytes, Way::kToStation)); };
        station.send = [this](std::string_view bytes) { link.write(onTheWire(bytes, Way::kFromStation)); };
    }

    enum class Way { kToStation, kFromStation };
    /// What comes out at the other end of a wire whose ends may talk differently.
    [[nodiscard]] std::string onTheWire(std::string_view bytes, Way way) const {
        const auto& own = station_settings.line;
        const auto client = own ? link.clientLine() : std::nullopt;
        if (!client) {
            return std::string(bytes);
        }
        const LineFraming theirs = clientFraming(*client, *own);
        return way == Way::kToStation ? heardAs(bytes, theirs, *own) : heardAs(bytes, *own, theirs);
    }

    core::Clock& clock;
    const StationSettings station_settings;
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
    if (!settings.panel_link_path.isEmpty()) {
        PMTS_TRY(simulation->plugPanel(settings.panel_link_path));
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

core::Result<QString> Simulation::plugPanel(QString link_path) {
    auto& panel = impl_->panel;
    if (!panel) {
        panel.emplace(link_path, impl_->station_settings, impl_->clock);
        if (auto opened = panel->link.open(); !opened) {
            panel.reset();
            return tl::unexpected(std::move(opened).error());
        }
        panel->unit.start();
    }
    return panel->link.slaveName();
}

void Simulation::unplugPanel() { impl_->panel.reset(); }

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
