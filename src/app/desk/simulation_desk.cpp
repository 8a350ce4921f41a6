#include "pmts/app/desk/simulation_desk.hpp"

#include "pmts/camera/scaled_rig.hpp"
#include "pmts/core/clock.hpp"
#include "pmts/geometry/polar.hpp"
#include "pmts/simulator/scene_camera.hpp"
#include "pmts/simulator/simulated_rig.hpp"
#include "pmts/simulator/simulation.hpp"

#include <cmath>
#include <utility>

namespace pmts::app {

namespace {

using simulator::Scene;
using simulator::TruePointing;

constexpr double kRightExposure_ms = 10.0;
constexpr double kBlurPerFocusStep = 0.12 / 1280.0;  // of the picture's width

simulator::CameraFaults faultsOf(const video::SimulatedExposure& setting, unsigned seed) {
    simulator::CameraFaults faults;
    faults.seed = seed;
    faults.exposure_gain = setting.exposure_ms / kRightExposure_ms * setting.gain;
    faults.noise_sigma *= std::sqrt(setting.gain);
    faults.blur_px = setting.out_of_focus * kBlurPerFocusStep * setting.size.width();
    return faults;
}

/// The camera's drawing is built on the thread that draws, with the first frame and with each change of mode.
class Painter {
public:
    Painter(std::shared_ptr<const Scene> scene, std::shared_ptr<const TruePointing> pointing, const SimulationChoice& choice,
            std::shared_ptr<const std::atomic<double>> turned_gon)
        : scene_(std::move(scene)), pointing_(std::move(pointing)), seed_(choice.seed), rig_(simulator::simulatedRig(choice.camera)),
          turned_gon_(std::move(turned_gon)) {}

    camera::Frame draw(core::Duration captured_at, const video::SimulatedExposure& setting) {
        const simulator::CameraFaults faults = faultsOf(setting, seed_);
        const double now_gon = turned_gon_->load();
        if (!camera_ || setting.size != drawn_as_.size || now_gon != drawn_gon_) {
            rig_.mount.twist += core::Angle::fromGon(now_gon - std::exchange(drawn_gon_, now_gon));
            const QSize size = setting.size;
            camera_ = std::make_unique<simulator::SceneCamera>(
                scene_, pointing_, camera::scaledRig(rig_, size.width(), size.height()), faults);
        } else if (!(setting == drawn_as_)) {
            camera_->setFaults(faults);
        }
        drawn_as_ = setting;
        return camera_->draw(captured_at);
    }

private:
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const TruePointing> pointing_;
    unsigned seed_;
    camera::Rig rig_;
    std::shared_ptr<const std::atomic<double>> turned_gon_;  ///< by hand, on the mount
    double drawn_gon_ = 0.0;
    video::SimulatedExposure drawn_as_;
    std::unique_ptr<simulator::SceneCamera> camera_;
};

video::ExposurePainter painterOf(std::shared_ptr<const Scene> scene, std::shared_ptr<const TruePointing> pointing,
                                 const SimulationChoice& choice, std::shared_ptr<const std::atomic<double>> turned_gon) {
    auto painter = std::make_shared<Painter>(std::move(scene), std::move(pointing), choice, std::move(turned_gon));
    return [painter](core::Duration captured_at, const video::SimulatedExposure& setting) {
        return painter->draw(captured_at, setting);
    };
}

std::vector<SceneMark> marksOf(const Scene& scene) {
    std::vector<SceneMark> marks;
    for (const simulator::Mark& mark : scene.marks()) {
        if (const auto place = geometry::polarFromStation(mark.p_station_m)) {
            marks.push_back({mark.name, place->pointing});
        }
    }
    return marks;
}

}  // namespace

geometry::Pointing inPresentFace(const SceneMark& mark, const std::optional<geometry::Pointing>& present) {
    const bool is_face_two = present && geometry::isFaceTwo(*present);
    return is_face_two ? geometry::otherFace(mark.pointing) : mark.pointing;
}

/// The simulator thread's side.
class SimulationDesk::Worker : public QObject {
public:
    explicit Worker(SimulationDesk& desk) : desk_(desk) {}

    void start(const SimulationChoice& choice) {
        simulator::SimulationSettings settings;
        settings.station.seed = choice.seed;
        settings.station.time_scale = choice.time_scale;
        settings.station.baud = choice.baud;
        if (const auto line = simulator::LineFraming::fromText(choice.line)) {
            settings.station.line = line;
            settings.station.baud = line->baud;
        }
        settings.scene_path = choice.scene_path;
        settings.faults = choice.faults;
        auto simulation = simulator::Simulation::start(std::move(settings), clock_);
        if (!simulation) {
            return say([error = simulation.error()](SimulationDesk& desk) { desk.showFailedStart(error); });
        }
        simulation_ = *std::move(simulation);
        simulation_->on_replugged = [this](const QString& port_path) {
            say([port_path](SimulationDesk& desk) { desk.showPluggedIn(port_path); });
        };
        say([path = simulation_->slaveName(), marks = marksOf(*simulation_->scene()),
             painter = painterOf(simulation_->scene(), simulation_->pointing(), choice, desk_.camera_turned_gon_)](
                SimulationDesk& desk) {
            desk.marks_ = marks;
            desk.showStarted(path, painter);
        });
        if (panel_wanted_) {
            plugPanel(true);
        }
    }

    void plugPanel(bool plugged) {
        panel_wanted_ = plugged;
        ask([this, plugged](simulator::Simulation& simulation) -> core::Result<void> {
            if (!plugged) {
                simulation.unplugPanel();
            }
            auto path = plugged ? simulation.plugPanel() : core::Result<QString>(QString());
            PMTS_TRY(path);
            say([path = *path](SimulationDesk& desk) { desk.showPanel(path); });
            return {};
        });
    }

    /// Does something with the simulation, when there is one, and reports what went wrong.
    void ask(const std::function<core::Result<void>(simulator::Simulation&)>& request) {
        if (!simulation_) {
            return;
        }
        if (const auto outcome = request(*simulation_); !outcome) {
            say([error = outcome.error()](SimulationDesk& desk) { Q_EMIT desk.problemReported(error); });
        }
    }

    void shutDown() { simulation_.reset(); }

private:
    template <class Words>
    void say(Words words) {
        QMetaObject::invokeMethod(&desk_, [&desk = desk_, words = std::move(words)] { words(desk); }, Qt::QueuedConnection);
    }

    SimulationDesk& desk_;
    core::SystemClock clock_;
    std::unique_ptr<simulator::Simulation> simulation_;
    bool panel_wanted_ = false;
};

SimulationDesk::SimulationDesk(QObject* parent) : QObject(parent), worker_(std::make_unique<Worker>(*this)) {
    thread_.setObjectName(QStringLiteral("simulator"));
    worker_->moveToThread(&thread_);
    thread_.start();
}

SimulationDesk::~SimulationDesk() {
    QMetaObject::invokeMethod(
        worker_.get(),
        [this] {
            worker_->shutDown();
            thread_.quit();
        },
        Qt::QueuedConnection);
    thread_.wait();
}

QStringList SimulationDesk::faultNames() { return simulator::Station::faultNames(); }

void SimulationDesk::start(const SimulationChoice& choice) {
    if (std::exchange(is_starting_, true)) {
        return;  // one simulator is enough: the instrument's and the camera's wish come together
    }
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), choice] { worker->start(choice); }, Qt::QueuedConnection);
}

void SimulationDesk::ask(std::function<core::Result<void>(simulator::Simulation&)> request) {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), request = std::move(request)] { worker->ask(request); },
        Qt::QueuedConnection);
}

void SimulationDesk::injectFault(const QString& fault) {
    ask([fault](simulator::Simulation& simulation) { return simulation.injectFault(fault); });
}

void SimulationDesk::pressRegKey() {
    ask([](simulator::Simulation& simulation) {
        simulation.station().pressRegKey();
        return core::Result<void>{};
    });
}

void SimulationDesk::turnCamera(core::Angle clockwise) {
    camera_turned_gon_->store(camera_turned_gon_->load() + clockwise.gon());
}

void SimulationDesk::unplug() {
    ask([](simulator::Simulation& simulation) {
        simulation.unplug();
        return core::Result<void>{};
    });
}

void SimulationDesk::plugIn() {
    ask([](simulator::Simulation& simulation) { return simulation.replug(); });
}

void SimulationDesk::plugPanel(bool plugged) {
    QMetaObject::invokeMethod(
        worker_.get(), [worker = worker_.get(), plugged] { worker->plugPanel(plugged); }, Qt::QueuedConnection);
}

void SimulationDesk::showPanel(const QString& port_path) {
    panel_path_ = port_path;
    Q_EMIT panelPlugged(port_path);
}

void SimulationDesk::showFailedStart(const core::Error& error) {
    is_starting_ = false;  // another choice may succeed
    Q_EMIT problemReported(error);
}

void SimulationDesk::showStarted(const QString& port_path, const video::ExposurePainter& painter) {
    is_starting_ = false;
    port_path_ = port_path;
    painter_ = painter;
    Q_EMIT started(port_path);
}

void SimulationDesk::showPluggedIn(const QString& port_path) {
    port_path_ = port_path;
    Q_EMIT pluggedIn(port_path);
}

}  // namespace pmts::app
