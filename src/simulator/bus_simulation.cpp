#include "pmts/simulator/bus_simulation.hpp"

#include "pmts/core/logging.hpp"
#include "pmts/transport/pty_link.hpp"

namespace pmts::simulator {

class BusSimulation::Impl {
public:
    Impl(const BusSimulationSettings& settings, core::Clock& the_clock)
        : clock(the_clock), link(settings.link_path), station(settings.station, pointing, the_clock) {
        pointing->place(settings.pointing);
        link.on_received = [this](std::string_view bytes) { station.receive(bytes); };
        station.send = [this](std::string_view bytes) { link.write(bytes); };
    }

    core::Clock& clock;
    std::shared_ptr<TruePointing> pointing = std::make_shared<TruePointing>();
    transport::PtyLink link;
    BusStation station;
    core::Timer unplug_timer, replug_timer;
};

core::Result<std::unique_ptr<BusSimulation>> BusSimulation::start(BusSimulationSettings settings, core::Clock& clock) {
    PMTS_TRY(checkSettings(settings.station));
    std::unique_ptr<BusSimulation> simulation(new BusSimulation(std::make_unique<Impl>(settings, clock)));
    PMTS_TRY(simulation->impl_->link.open());
    for (const QString& fault : std::as_const(settings.faults)) {
        PMTS_TRY(simulation->station().injectFault(fault));
    }
    return simulation;
}

BusSimulation::BusSimulation(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {
    impl_->station.on_unplug = [this](core::Duration span) {
        // Not at once: the fault may have been ordered while the link is handing out bytes.
        impl_->unplug_timer = impl_->clock.callAfter({}, [this] { impl_->link.close(); });
        impl_->replug_timer = impl_->clock.callAfter(span, [this] {
            if (const auto back = impl_->link.open(); !back) {
                qCWarning(core::logSimulator) << "the pty did not come back:" << back.error().sentence();
            } else if (on_replugged) {
                on_replugged(slaveName());
            }
        });
    };
}

BusSimulation::~BusSimulation() = default;

QString BusSimulation::slaveName() const { return impl_->link.slaveName(); }
BusStation& BusSimulation::station() { return impl_->station; }

}  // namespace pmts::simulator
