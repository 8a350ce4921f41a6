#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"

#include <QObject>
#include <QThread>

#include <atomic>
#include <cstdint>
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

    /// Probability of a step of its start-up to fail for each picture that the host draws during it (thesis 8.3.4); 0: the
    /// video does not matter. Of the next base that is started: another value than before starts a new one.
    void setVideoSensitivity(double failure_per_frame) { failure_per_frame_ = failure_per_frame; }

public Q_SLOTS:
    void start();       ///< once; later calls only say again where it is
    void countFrame();  ///< the host has drawn a picture

Q_SIGNALS:
    void started(const QString& port_path);
    void problemReported(const pmts::core::Error& error);

private:
    void startHere(double failure_per_frame);

    QThread thread_;
    std::unique_ptr<QObject> worker_ = std::make_unique<QObject>();  ///< lives on the thread
    core::SystemClock clock_;
    double failure_per_frame_ = 0.0;
    std::atomic<std::uint64_t> frames_{0};  ///< counted on the GUI thread, read on the simulator's
    std::unique_ptr<simulator::BusSimulation> simulation_;  ///< of the thread
    double started_with_ = 0.0;                             ///< of the thread
};

}  // namespace pmts::app
