#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"

#include <QObject>
#include <QThread>

#include <memory>

namespace pmts::simulator {
class BusSimulation;
}

namespace pmts::app {

/// A simulated base on its bus, on a thread of its own, served on a pty: to try routines without hardware.
class BusSimulationDesk : public QObject {
    Q_OBJECT
public:
    explicit BusSimulationDesk(QObject* parent = nullptr);
    ~BusSimulationDesk() override;

public Q_SLOTS:
    void start();  ///< once; later calls only say again where it is

Q_SIGNALS:
    void started(const QString& port_path);
    void problemReported(const pmts::core::Error& error);

private:
    void startHere();

    QThread thread_;
    std::unique_ptr<QObject> worker_ = std::make_unique<QObject>();  ///< lives on the thread
    core::SystemClock clock_;
    std::unique_ptr<simulator::BusSimulation> simulation_;  ///< of the thread
};

}  // namespace pmts::app
