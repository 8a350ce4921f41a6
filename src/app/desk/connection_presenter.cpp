#include "pmts/app/desk/connection_presenter.hpp"

#include "adapter_port.hpp"
#include "camera_finder.hpp"
#include "pmts/protocol/units.hpp"
#include "pmts/transport/port_finder.hpp"

#include <algorithm>
#include <utility>

namespace pmts::app {

namespace {

const QString kTopic = QStringLiteral("connection");

DeviceState lampOf(ConnectionState state) {
    switch (state) {
        case ConnectionState::kDisconnected: return DeviceState::kIdle;
        case ConnectionState::kConnecting: return DeviceState::kBusy;
        case ConnectionState::kConnected: return DeviceState::kGood;
        case ConnectionState::kReconnecting: return DeviceState::kWarning;
    }
    return DeviceState::kIdle;
}

std::vector<PortChoice> portChoices(const SerialChoice& last, const std::vector<transport::PortInfo>& present) {
    std::vector<PortChoice> choices;
    const QString path = pathNow(last, present);
    for (const transport::PortInfo& port : present) {
        choices.push_back({.path = port.path,
                           .name = port.friendlyName(),
                           .adapter = port.identity(),
                           .used_last = port.path == path && !isAnothersPort(last, {port})});
    }
    std::stable_partition(choices.begin(), choices.end(), [](const PortChoice& choice) { return choice.used_last; });
    return choices;
}

}  // namespace

ConnectionPresenter::ConnectionPresenter(InstrumentDesk& instrument, SimulationDesk& simulation, LivePresenter& live,
                                         core::VideoGate& gate, Preferences& preferences, MessageCentre& messages,
                                         LookForCameras look, QObject* parent)
    : QObject(parent), instrument_(instrument), simulation_(simulation), live_(live), gate_(gate),
      preferences_(preferences), messages_(messages), cameras_{simulatedCamera()},
      finder_(std::make_unique<CameraFinder>(std::move(look))) {
    connect(finder_.get(), &CameraFinder::found, this, &ConnectionPresenter::showCameras);
    connect(&instrument_, &InstrumentDesk::connectionChanged, this, &ConnectionPresenter::onConnection);
    connect(&instrument_, &InstrumentDesk::connectFailed, this, &ConnectionPresenter::onConnectFailed);
    connect(&instrument_, &InstrumentDesk::identityChanged, this, [this] {
        showStatus();
        Q_EMIT identityChanged();
    });
    connect(&instrument_, &InstrumentDesk::progressChanged, this, &ConnectionPresenter::showStatus);
    connect(&instrument_, &InstrumentDesk::warningsChanged, this, &ConnectionPresenter::showWarnings);
    connect(&simulation_, &SimulationDesk::started, this, &ConnectionPresenter::onSimulatorStarted);
    connect(&simulation_, &SimulationDesk::pluggedIn, this, [this](const QString& port_path) {
        if (simulated_wanted_) {
            instrument_.offerAddress(port_path);
        }
    });
    connect(&simulation_, &SimulationDesk::problemReported, this, [this](const core::Error& error) {
        messages_.report(error, MessageAction::kShowLog, QStringLiteral("simulator"));
    });
}

ConnectionPresenter::~ConnectionPresenter() = default;

std::vector<int> ConnectionPresenter::baudRates() { return {9600, 4800, 19200, 2400, 1200, 300}; }

SerialChoice ConnectionPresenter::serialChoice() const {
    SerialChoice choice = preferences_.settings().serial;
    if (!ports_.empty() && (choice.path.isEmpty() || ports_.front().used_last)) {
        choice.path = ports_.front().path;
        choice.adapter = ports_.front().adapter;
    }
    return choice;
}

StatusItem ConnectionPresenter::instrumentStatus() const {
    const bool connected = instrument_.connectionState() == ConnectionState::kConnected;
    StatusItem item{.state = lampOf(instrument_.connectionState()), .text = tr("No instrument"),
                    .details = instrument_.connectionSentence()};
    if (connected && instrument_.isBusy()) {
        item.state = DeviceState::kBusy;
    }
    if (const auto& identity = instrument_.identity()) {
        item.text = identity->model.isEmpty() ? tr("Instrument") : identity->model;
    }
    if (!connected && last_failure_) {
        item.state = DeviceState::kFailed;
        item.details = last_failure_->sentence();
    }
    return item;
}

std::vector<IdentityLine> ConnectionPresenter::identityLines() const {
    const auto& identity = instrument_.identity();
    if (!identity) {
        return {};
    }
    if (instrument_.choice().dialect == instrument::LineDialect::kBus) {
        return {{tr("Model"), identity->model},
                {tr("Angles"), tr("gon with five decimals, they come by themselves")},
                {tr("Port"), instrument_.choice().text()}};
    }
    const QString end_mark = identity->end_mark ? QStringLiteral("%1 (%2)").arg(*identity->end_mark).arg(int{*identity->end_mark})
                                                : tr("none");
    return {{tr("Model"), identity->model},
            {tr("Serial number (label 55)"), identity->serial_number},
            {tr("Units (label 23)"), QString::fromStdString(protocol::unitStatusText(identity->units))},
            {tr("End mark (label 79)"), end_mark},
            {tr("Port"), instrument_.choice().text()}};
}

std::vector<DoctorStep> ConnectionPresenter::doctorSteps() const {
    if (instrument_.connectionState() == ConnectionState::kConnected || !last_failure_) {
        return {};
    }
    std::vector<DoctorStep> steps;
    const bool is_port = last_failure_->kind == core::ErrorKind::kPortUnavailable;
    steps.push_back({is_port ? tr("The port") : tr("What the line shows"), last_failure_->sentence()});
    steps.push_back({tr("Power"), tr("Switch the instrument on, level it and let its start-up finish.")});
    steps.push_back({tr("Cable"), tr("Plug the data cable into the foot of the instrument and into the computer; "
                                     "an adapter's lamp should light.")});
    steps.push_back({tr("Serial interface"), tr("On the control unit choose the serial interface as data device and set it on.")});
    steps.push_back({tr("Line parameters (label 78)"),
                     tr("Set 1.8.0.9600 on the instrument: 1 stop bit, 8 data bits, no parity, 9600 baud. PMTS uses %1.")
                         .arg(instrument_.choice().text())});
    steps.push_back({tr("End mark (label 79)"), tr("Set 62 on the instrument: every answer then ends with “>”.")});
    steps.push_back({tr("Another baud rate"), tr("A Geodimeter 500 often speaks 4800 baud: choose it in the list and connect again.")});
    steps.push_back({tr("Another program"), tr("Close other programs that use the same port.")});
    return steps;
}

bool ConnectionPresenter::canSwitchOn() const {
    return instrument_.connectionState() == ConnectionState::kDisconnected && last_failure_ &&
           last_failure_->kind == core::ErrorKind::kTimeOut &&
           instrument_.choice().dialect == instrument::LineDialect::kExternal;
}

void ConnectionPresenter::refreshPorts() {
    ports_ = portChoices(preferences_.settings().serial, list_ports_());
    Q_EMIT portsChanged();
}

void ConnectionPresenter::refresh() {
    refreshPorts();
    finder_->look();
    Q_EMIT camerasChanged();
}

bool ConnectionPresenter::isLookingForCameras() const { return finder_->isLooking(); }

QString ConnectionPresenter::cameraListNote() const { return isLookingForCameras() ? tr("Looking for cameras…") : QString(); }

void ConnectionPresenter::showCameras(const std::vector<video::SourceAddress>& found) {
    cameras_ = found;
    cameras_.insert(cameras_.begin(), simulatedCamera());
    Q_EMIT camerasChanged();
}

// Instrument --------------------------------------------------------------------------------------------------------

void ConnectionPresenter::startSimulated() {
    startCamera(simulatedCamera());
    startSimulatedInstrument();
}

void ConnectionPresenter::restartSimulation(const SimulationChoice& choice) {
    simulation_choice_ = choice;
    simulated_wanted_ = simulated_camera_wanted_ = true;
    keepDevice(LastDevice::kSimulated, preferences_.settings().serial);
    simulation_.start(choice);
}

void ConnectionPresenter::connectSimulated() {
    keepDevice(LastDevice::kSimulated, preferences_.settings().serial);
    startSimulatedInstrument();
}

void ConnectionPresenter::startSimulatedInstrument() {
    simulated_wanted_ = true;
    if (!simulation_.isRunning()) {
        simulation_.start(simulation_choice_);
        return;
    }
    SerialChoice choice;
    choice.path = simulation_.portPath();
    instrument_.connectSerial(choice);
}

void ConnectionPresenter::connectSerial(const SerialChoice& choice) {
    simulated_wanted_ = false;
    SerialChoice known = choice;
    const auto port = std::find_if(ports_.begin(), ports_.end(), [&](const PortChoice& p) { return p.path == choice.path; });
    if (port != ports_.end()) {
        known.adapter = port->adapter;
    }
    keepDevice(LastDevice::kSerial, known);
    instrument_.connectSerial(known);
}

void ConnectionPresenter::connectFound(const SerialChoice& choice) {
    if (!simulation_.isRunning() || choice.path != simulation_.portPath()) {
        connectSerial(choice);
        refreshPorts();  // the form shows what was found
        return;
    }
    keepDevice(LastDevice::kSimulated, preferences_.settings().serial);
    simulated_wanted_ = true;
    instrument_.connectSerial(choice);
}

void ConnectionPresenter::switchOn() {
    if (canSwitchOn()) {
        last_failure_.reset();
        Q_EMIT doctorChanged();
        instrument_.switchOnSerial(instrument_.choice());
    }
}

void ConnectionPresenter::disconnectInstrument() {
    simulated_wanted_ = false;
    instrument_.disconnectInstrument();
}

void ConnectionPresenter::keepDevice(LastDevice device, const SerialChoice& choice) {
    last_failure_.reset();
    Settings next = preferences_.settings();
    next.last_device = device;
    next.serial = choice;
    preferences_.set(next);
    Q_EMIT doctorChanged();
}

void ConnectionPresenter::onConnection(ConnectionState state, const QString& sentence) {
    switch (state) {
        case ConnectionState::kConnected:
            last_failure_.reset();
            messages_.solve(kTopic);
            break;
        case ConnectionState::kReconnecting:
            messages_.warn(sentence, tr("PMTS connects again by itself as soon as the instrument answers."),
                           MessageAction::kOpenConnectionPage, kTopic);
            break;
        case ConnectionState::kConnecting: showWarnings({}); break;
        case ConnectionState::kDisconnected:
            showWarnings({});
            if (!last_failure_) {
                messages_.solve(kTopic);
            }
            break;
    }
    showStatus();
    Q_EMIT doctorChanged();
}

void ConnectionPresenter::onConnectFailed(const core::Error& error) {
    last_failure_ = error;
    messages_.report(error, MessageAction::kOpenConnectionPage, kTopic);
    messages_.cue(Cue::kFailed);
    showStatus();
    Q_EMIT doctorChanged();
}

/// Each is said once: a bar that was dismissed does not come back while its trouble goes on.
void ConnectionPresenter::showWarnings(const std::vector<core::Error>& standing) {
    QStringList topics;
    for (const core::Error& warning : standing) {
        topics.append(QStringLiteral("info %1").arg(warning.info_code.value_or(0)));
        if (!warning_topics_.contains(topics.back())) {
            messages_.warn(warning.happened, warning.remedy, MessageAction::kNone, topics.back());
        }
    }
    for (const QString& topic : std::as_const(warning_topics_)) {
        if (!topics.contains(topic)) {
            messages_.solve(topic);
        }
    }
    warning_topics_ = topics;
}

void ConnectionPresenter::showStatus() { Q_EMIT instrumentStatusChanged(instrumentStatus()); }

void ConnectionPresenter::onSimulatorStarted(const QString&) {
    if (simulated_wanted_) {
        startSimulatedInstrument();
    }
    if (simulated_camera_wanted_) {
        startSimulatedCamera();
    }
}

// Camera ------------------------------------------------------------------------------------------------------------

video::SourceAddress ConnectionPresenter::simulatedCamera() {
    return {.kind = video::SourceKind::kSimulated, .location = {}, .name = tr("Simulated camera")};
}

void ConnectionPresenter::chooseCamera(const video::SourceAddress& address) {
    Settings next = preferences_.settings();
    next.camera = address;
    preferences_.set(next);
    startCamera(address);
}

void ConnectionPresenter::startCamera(const video::SourceAddress& address) {
    simulated_camera_wanted_ = address.kind == video::SourceKind::kSimulated;
    if (!simulated_camera_wanted_) {
        live_.setSource(video::makeVideoSource(address, gate_));
        Q_EMIT rigChanged();
    } else if (simulation_.isRunning()) {
        startSimulatedCamera();
    } else {
        simulation_.start(simulation_choice_);
    }
}

void ConnectionPresenter::startSimulatedCamera() {
    live_.setSource(video::makeSimulatedSource(simulation_.painter(), gate_));
    Q_EMIT rigChanged();
}

// Rig ---------------------------------------------------------------------------------------------------------------

std::vector<RigProfile> ConnectionPresenter::rigProfiles() const {
    std::vector<RigProfile> profiles = preferences_.settings().rig_profiles;
    std::erase_if(profiles, [](const RigProfile& profile) { return profile.use && profile.use->isSimulated(); });
    profiles.insert(profiles.begin(), preferences_.settings().rigOf(video::SourceKind::kSimulated));
    return profiles;
}

RigProfile ConnectionPresenter::rigProfile() const { return preferences_.settings().chosenRig(); }

QString ConnectionPresenter::rigNote() const {
    const video::VideoSource* const camera = live_.source();
    if (!camera || preferences_.settings().rigOf(camera->address().kind).name == rigProfile().name) {
        return {};
    }
    return tr("The simulated camera is in use and has its own rig; this profile waits for a real camera.");
}

void ConnectionPresenter::chooseRigProfile(const QString& name) {
    Settings next = preferences_.settings();
    next.rig_profile = name;
    preferences_.set(next);
    Q_EMIT rigChanged();
}

void ConnectionPresenter::saveRigProfile(const RigProfile& profile) {
    if (profile.name.trimmed().isEmpty() || profile.name == simulatedRigProfile().name) {
        messages_.warn(tr("The rig profile was not kept."), tr("Give it a name of its own."), MessageAction::kNone,
                       QStringLiteral("rig"));
        return;
    }
    keepRig(profile);
}

void ConnectionPresenter::keepRig(const RigProfile& profile) {
    messages_.solve(QStringLiteral("rig"));
    Settings next = preferences_.settings();
    std::erase_if(next.rig_profiles, [&profile](const RigProfile& old) { return old.name == profile.name; });
    next.rig_profiles.push_back(profile);
    next.rig_profile = profile.name;
    preferences_.set(next);
    Q_EMIT rigChanged();
}

void ConnectionPresenter::importRigProfile(const QString& path) {
    const auto profile = loadRigProfile(path);
    if (!profile) {
        messages_.report(profile.error(), MessageAction::kNone, QStringLiteral("rig"));
        return;
    }
    saveRigProfile(*profile);
}

void ConnectionPresenter::exportRigProfile(const QString& path) {
    if (const auto saved = app::saveRigProfile(rigProfile(), path); !saved) {
        messages_.report(saved.error(), MessageAction::kNone, QStringLiteral("rig"));
        return;
    }
    messages_.toast(tr("The rig profile is saved."));
}

}  // namespace pmts::app
