#include "soak_field.hpp"

#include <QFile>

#include <stdexcept>

namespace pmts::soak {
namespace {

using namespace std::chrono_literals;

const QString kInstrumentPort = QStringLiteral("instrument");
const QString kPanelPort = QStringLiteral("panel");

/// Two walls of a yard, 20 m to the north and 30 m to the east, and a black panel before the northern one.
simulator::Scene yard() {
    const auto wall = [](Eigen::Vector3d origin_m, Eigen::Vector3d right_m, bool absorbing) {
        return simulator::Panel{.name = QStringLiteral("wall"), .origin_m = origin_m, .right_m = right_m, .up_m = {0, 0, 40},
                                .texture = cv::Mat(4, 4, CV_8UC3, cv::Scalar::all(90)), .absorbing = absorbing};
    };
    return simulator::Scene({wall({-40, 20, -20}, {70, 0, 0}, false), wall({30, 40, -20}, {0, -80, 0}, false),
                             wall({-3, 19.9, -20}, {3, 0, 0}, true)});
}

simulator::StationSettings stationSettings(unsigned seed) {
    simulator::StationSettings settings;
    settings.seed = seed;
    return settings;
}

simulator::ControlUnitSettings panelSettings(unsigned seed) {
    simulator::ControlUnitSettings settings;
    settings.seed = seed;
    settings.shortest_pause = 2s;
    settings.longest_pause = 30s;
    return settings;
}

}  // namespace

SoakField::SoakField(unsigned seed)
    : scene(std::make_shared<const simulator::Scene>(yard())),
      station(stationSettings(seed), scene, truth, time),
      panel(panelSettings(seed), time) {
    targeting.setRecentring(false);  // its pictures are empty
    live.setSource(std::unique_ptr<video::VideoSource>(camera));
    live.startCamera();
    black_box.watch(instrument);
    black_box.watch(live, gate_);
    panel.send = [this](std::string_view bytes) {
        if (panel_end_) {
            panel_end_->write(bytes);
        }
    };
    panel.is_plugged = [this] { return panel_is_plugged_; };
    control_.panel.emplace();
    control_.panel->path = kPanelPort;
    instrument.setControl(control_);
    panel.start();
}

/// Routines that are suspended end before the clocks go.
SoakField::~SoakField() {
    panel.stop();
    instrument.disconnectInstrument();
    live.setSource(nullptr);
    disk_.cancel();
    pass(1min);
}

app::InstrumentWiring SoakField::wiring() {
    app::InstrumentWiring wiring;
    wiring.threading = app::Threading::kCallersThread;
    wiring.clock = &time;
    wiring.make_link = [this](const app::SerialChoice& choice) { return makeLink(choice); };
    wiring.find_patch = targeting::findHere(targeting::PatchMatcher());
    wiring.connection.profile.time_critical = {"PV,20", "WS", "TG"};  // the video pauses for every move and every shot
    return wiring;
}

std::unique_ptr<transport::ByteLink> SoakField::makeLink(const app::SerialChoice& choice) {
    if (choice.path == kPanelPort) {
        return makePanelLink();
    }
    auto pair = transport::makeMemoryPair(time);
    if (!is_plugged_) {
        pair.first->unplug();
        return std::move(pair.first);
    }
    instrument_end_ = std::move(pair.second);
    (void)instrument_end_->open();
    instrument_end_->on_received = [this](std::string_view bytes) { station.receive(bytes); };
    station.send = [this](std::string_view bytes) { instrument_end_->write(bytes); };
    return black_box.tapped(std::move(pair.first));
}

std::unique_ptr<transport::ByteLink> SoakField::makePanelLink() {
    auto pair = transport::makeMemoryPair(time);
    if (!panel_is_plugged_) {
        pair.first->unplug();
        return std::move(pair.first);
    }
    panel_end_ = std::move(pair.second);
    (void)panel_end_->open();
    panel_end_->on_received = [this](std::string_view bytes) { panel.receive(bytes); };
    return std::move(pair.first);
}

bool SoakField::until(const std::function<bool()>& so, core::Duration limit) {
    constexpr int kLongestChain = 1000;  ///< of calls between desks, without a timer
    const core::Duration latest = time.now() + limit;
    int without_timer = 0;
    core::deliverQueuedEvents();
    while (!so()) {
        without_timer = time.advanceToNextTimer(latest) ? 0 : without_timer + 1;
        if (without_timer > kLongestChain) {
            return false;
        }
        core::deliverQueuedEvents();
    }
    return true;
}

void SoakField::openJob() {
    job.create(jobPath());
    if (!until([this] { return job.isOpen(); }, 10s)) {
        throw std::runtime_error("the job cannot be made");
    }
}

void SoakField::connect() {
    app::SerialChoice choice;
    choice.path = kInstrumentPort;
    instrument.connectSerial(choice);
}

void SoakField::pullCable() {
    is_plugged_ = false;
    if (instrument_end_) {
        instrument_end_->unplug();
    }
}

void SoakField::pullPanel() {
    panel_is_plugged_ = false;
    if (panel_end_) {
        panel_end_->unplug();
    }
}

void SoakField::setMode(scheduler::ControlMode mode) {
    control_.mode = mode;
    instrument.setControl(control_);
}

void SoakField::pressReg() {
    pressed_at_ = truth->at(time.now());
    pressed_when_ = time.now();
    station.pressRegKey();
}

void SoakField::startBlackBox() {
    app::Settings next = preferences.settings();
    next.black_box = {.on = true, .kept_mb = 4000, .frames_per_s = 0.02};
    preferences.set(next);
    black_box.start();
    letBlackBoxWrite();
}

void SoakField::letBlackBoxWrite() {
    black_box.waitUntilWritten();
    disk_ = time.callAfter(1s, [this] { letBlackBoxWrite(); });
}

void SoakField::moveJobAway() { QFile::rename(jobPath(), jobPath() + QStringLiteral(".away")); }

void SoakField::bringJobBack() { QFile::rename(jobPath() + QStringLiteral(".away"), jobPath()); }

}  // namespace pmts::soak
