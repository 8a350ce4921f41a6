#include "pmts/app/bus_simulation_desk.hpp"

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
    QMetaObject::invokeMethod(worker_.get(), [this] { startHere(); }, Qt::QueuedConnection);
}

void BusSimulationDesk::startHere() {
    if (!simulation_) {
        auto simulation = simulator::BusSimulation::start({}, clock_);
        if (!simulation) {
            Q_EMIT problemReported(simulation.error());
            return;
        }
        simulation_ = *std::move(simulation);
    }
    Q_EMIT started(simulation_->slaveName());
}

}  // namespace pmts::app
