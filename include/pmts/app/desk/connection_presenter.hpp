#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/lab/rig_profile.hpp"
#include "pmts/app/desk/serial_choice.hpp"
#include "pmts/app/desk/simulation_desk.hpp"

#include <QObject>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace pmts::app {

class CameraFinder;

/// A line of the connection doctor: what to look at or set on the instrument.
struct DoctorStep {
    QString title;
    QString text;
};

/// A line of the identification: `Serial number`, `620123`.
struct IdentityLine {
    QString name;
    QString value;
};

/// The connection page: instrument, camera, rig.
class ConnectionPresenter : public QObject {
    Q_OBJECT
public:
    /// What is plugged in now; called on a thread of its own.
    using LookForCameras = std::function<std::vector<video::SourceAddress>()>;

    ConnectionPresenter(InstrumentDesk& instrument, SimulationDesk& simulation, LivePresenter& live, core::VideoGate& gate,
                        Preferences& preferences, MessageCentre& messages, LookForCameras look = video::presentCameras,
                        QObject* parent = nullptr);
    ~ConnectionPresenter() override;

    [[nodiscard]] const std::vector<PortChoice>& ports() const { return ports_; }
    [[nodiscard]] const std::vector<video::SourceAddress>& cameras() const { return cameras_; }  ///< the simulated one first
    /// Between refresh() and the camerasChanged() that ends it: the page says so.
    [[nodiscard]] bool isLookingForCameras() const;
    /// `Looking for cameras…` meanwhile, else empty.
    [[nodiscard]] QString cameraListNote() const;
    [[nodiscard]] static std::vector<int> baudRates();
    [[nodiscard]] SerialChoice serialChoice() const;  ///< what the form shows first
    [[nodiscard]] StatusItem instrumentStatus() const;
    [[nodiscard]] std::vector<IdentityLine> identityLines() const;
    /// What to set on the instrument, most likely cause first. Empty when connected.
    [[nodiscard]] std::vector<DoctorStep> doctorSteps() const;
    /// Nothing answered on an open port: the instrument may be off.
    [[nodiscard]] bool canSwitchOn() const;
    [[nodiscard]] std::vector<RigProfile> rigProfiles() const;
    [[nodiscard]] RigProfile rigProfile() const;
    [[nodiscard]] QString rigNote() const;  ///< empty unless the camera in use leaves the chosen profile aside
    /// How the simulator is started when it is first needed.
    void setSimulation(const SimulationChoice& choice) { simulation_choice_ = choice; }
    /// Takes the place of the computer's own list of ports.
    void setPortList(InstrumentWiring::ListPorts list) { list_ports_ = std::move(list); }
    [[nodiscard]] const SimulationChoice& simulation() const { return simulation_choice_; }
    /// Another simulated world takes the place of the running one; instrument and camera go on in it.
    void restartSimulation(const SimulationChoice& choice);
    [[nodiscard]] static video::SourceAddress simulatedCamera();

public Q_SLOTS:
    void refreshPorts();
    void refresh();  ///< looks for ports and cameras again; camerasChanged() comes at once and when they are found
    /// Simulated instrument and camera for this run only: what is remembered for the next start stays.
    void startSimulated();
    void connectSimulated();
    void connectSerial(const pmts::app::SerialChoice& choice);
    /// Where a search has found the instrument; the simulator's port is not remembered for the next start.
    void connectFound(const pmts::app::SerialChoice& choice);
    void switchOn();  ///< by a BREAK on the port that was tried last, then connects
    void disconnectInstrument();
    void chooseCamera(const pmts::video::SourceAddress& address);
    void chooseRigProfile(const QString& name);
    void saveRigProfile(const pmts::app::RigProfile& profile);
    void importRigProfile(const QString& path);
    void exportRigProfile(const QString& path);

Q_SIGNALS:
    void portsChanged();
    void camerasChanged();
    void instrumentStatusChanged(const pmts::app::StatusItem& status);
    void identityChanged();
    void doctorChanged();
    void rigChanged();  ///< the profiles, the chosen one, or the camera that uses it

private:
    void onConnection(ConnectionState state, const QString& sentence);
    void onConnectFailed(const core::Error& error);
    void onSimulatorStarted(const QString& port_path);
    void startCamera(const video::SourceAddress& address);
    void startSimulatedCamera();
    void startSimulatedInstrument();
    void showCameras(const std::vector<video::SourceAddress>& found);
    void keepDevice(LastDevice device, const SerialChoice& choice);
    void keepRig(const RigProfile& profile);
    void showStatus();
    void showWarnings(const std::vector<core::Error>& standing);

    InstrumentDesk& instrument_;
    SimulationDesk& simulation_;
    LivePresenter& live_;
    core::VideoGate& gate_;
    Preferences& preferences_;
    MessageCentre& messages_;
    InstrumentWiring::ListPorts list_ports_ = transport::listPorts;
    std::vector<PortChoice> ports_;
    std::vector<video::SourceAddress> cameras_;
    std::unique_ptr<CameraFinder> finder_;
    std::optional<core::Error> last_failure_;
    QStringList warning_topics_;  ///< of what the instrument warns of and has been said
    SimulationChoice simulation_choice_;
    bool simulated_wanted_ = false;
    bool simulated_camera_wanted_ = false;
};

}  // namespace pmts::app
