#include "pmts/app/desk/bus_simulation_desk.hpp"

#include "pmts/simulator/bus_simulation.hpp"

namespace pmts::app {

BusSimulationDesk::BusSimulationDesk(QObject* parent) : QObject(parent) {
    thread_.setObjectName(QStringLiteral("bus simulator"));
    worker_->moveToThread(&thread_);
}

BusSimulationDesk::~BusSimulationDesk() {
    if (thread_.isRunning()) {
        QMetaObject::invokeMethod(
            worker_.get(),
            [this] {
                simulation_.reset();
                thread_.quit();
            },
            Qt::QueuedConnection);
        thread_.wait();
    }
}

void BusSimulationDesk::start() {
    if (!thread_.isRunning()) {
        thread_.start();
    }
    QMetaObject::invokeMethod(worker_.get(), [this, sensitivity = failure_per_frame_] { startHere(sensitivity); },
                              Qt::QueuedConnection);
}

void BusSimulationDesk::countFrame() { frames_.fetch_add(1, std::memory_order_relaxed); }

void BusSimulationDesk::startHere(double failure_per_frame) {
    if (simulation_ && started_with_ != failure_per_frame) {
        simulation_.reset();
    }
    if (!simulation_) {
        simulator::BusSimulationSettings settings;
        settings.station.start_up.failure_per_frame = failure_per_frame;
        auto simulation = simulator::BusSimulation::start(settings, clock_);
        if (!simulation) {
            Q_EMIT problemReported(simulation.error());
            return;
        }
        simulation_ = *std::move(simulation);
        simulation_->station().frames_of_host = [this] { return frames_.load(std::memory_order_relaxed); };
        started_with_ = failure_per_frame;
    }
    Q_EMIT started(simulation_->slaveName());
}

}  // namespace pmts::app
