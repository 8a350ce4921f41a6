#pragma once

#include "pmts/app/desk/connection_presenter.hpp"
#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/threading.hpp"
#include "pmts/instrument/line_probe.hpp"

#include <QObject>
#include <QThread>

#include <memory>
#include <optional>
#include <vector>

namespace pmts::app {

/// How ports are probed. The defaults are the program's; tests put links and a virtual clock in.
struct ProbeWiring {
    Threading threading = Threading::kOwnThread;
    core::Clock* clock = nullptr;                ///< null: a SystemClock on the probe's thread
    instrument::LineProbe::MakeLink make_link;  ///< empty: a serial port
};

/// Looks for the instrument on ports, with the line settings it may have: what is tried now, how far it is, a verdict, and
/// what was found for the connection. The ports are opened on a thread of their own.
class ProbePresenter : public QObject {
    Q_OBJECT
public:
    ProbePresenter(ConnectionPresenter& connection, InstrumentDesk& instrument, SimulationDesk& simulation,
                   ProbeWiring wiring = {}, QObject* parent = nullptr);
    ~ProbePresenter() override;  ///< ends the search and joins its thread

    /// The ports of this computer, and the simulated instrument's while it runs.
    [[nodiscard]] std::vector<PortChoice> ports() const;
    /// Why the search cannot begin now; empty when it can.
    [[nodiscard]] QString refusal() const;
    [[nodiscard]] bool isRunning() const { return is_running_; }
    [[nodiscard]] QString stepText() const { return step_text_; }  ///< `/dev/ttyUSB0 at 4800 8N1 (2 of 36)`
    [[nodiscard]] double fraction() const { return fraction_; }
    [[nodiscard]] const StatusItem& verdict() const { return verdict_; }  ///< no text before the first one
    [[nodiscard]] const std::optional<SerialChoice>& found() const { return found_; }

public Q_SLOTS:
    void start(const QStringList& paths);
    void cancel();
    void useFound();  ///< connects with what was found

Q_SIGNALS:
    void changed();

private:
    class Worker;
    void begin();
    void showStep(const instrument::ProbeStep& step);
    void finish(const core::Result<instrument::ProbeOutcome>& outcome);
    void judge(const instrument::ProbeOutcome& outcome);

    ConnectionPresenter& connection_;
    InstrumentDesk& instrument_;
    SimulationDesk& simulation_;
    QThread thread_;
    std::shared_ptr<Worker> worker_;
    QStringList paths_;
    bool is_running_ = false;
    bool waits_for_port_ = false;  ///< the instrument is being disconnected first
    QString step_text_;
    double fraction_ = 0.0;
    StatusItem verdict_;
    std::optional<SerialChoice> found_;
};

}  // namespace pmts::app
