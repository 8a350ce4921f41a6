#include "simulated_hands.hpp"

#include "pmts/app/desk/bus_simulation_desk.hpp"

#include <QAction>
#include <QMenu>

#include <utility>

namespace pmts::gui {
namespace {

/// Of a step of 20 ms in which one picture falls at 30 a second, more often than not: one of six steps fails nearly always.
constexpr double kDisturbedByAPicture = 0.5;

void addScenes(QMenu& menu, app::Workbench& bench) {
    QMenu* const scenes = menu.addMenu(QObject::tr("Scene"));
    const std::pair<QString, QString> all[] = {{{}, QObject::tr("Town square")},
                                               {QStringLiteral("laboratory"), QObject::tr("Laboratory")}};
    for (const auto& [name, text] : all) {
        QAction* const action = scenes->addAction(text);
        action->setCheckable(true);
        QObject::connect(action, &QAction::triggered, &bench.connection, [&bench, name = name] {
            app::SimulationChoice choice = bench.connection.simulation();
            choice.scene_path = name;
            bench.connection.restartSimulation(choice);
        });
        QObject::connect(scenes, &QMenu::aboutToShow, action,
                         [&bench, action, name = name] { action->setChecked(bench.connection.simulation().scene_path == name); });
    }
}

void addEyepiece(QMenu& menu, app::Workbench& bench) {
    QMenu* const sights = menu.addMenu(QObject::tr("Point the telescope at a mark"));
    QObject::connect(sights, &QMenu::aboutToShow, sights, [&bench, sights] {
        sights->clear();
        for (const app::SceneMark& mark : bench.simulation.marks()) {
            sights->addAction(mark.name, &bench.instrument, [&bench, mark] {
                const auto present = bench.instrument.track().newest();
                const auto at = app::inPresentFace(mark, present ? std::optional(present->pointing) : std::nullopt);
                bench.instrument.turnTo(at, bench.preferences.settings().turn_tolerance);
            });
        }
    });
}

void addClamp(QMenu& menu, app::Workbench& bench) {
    QMenu* const clamp = menu.addMenu(QObject::tr("Turn the camera in its clamp"));
    const std::pair<double, QString> all[] = {{1.0, QObject::tr("Clockwise by 1 gon")},
                                              {0.1, QObject::tr("Clockwise by 0.1 gon")},
                                              {0.01, QObject::tr("Clockwise by 0.01 gon")},
                                              {-1.0, QObject::tr("Anticlockwise by 1 gon")},
                                              {-0.1, QObject::tr("Anticlockwise by 0.1 gon")},
                                              {-0.01, QObject::tr("Anticlockwise by 0.01 gon")}};
    for (const auto& [gon, text] : all) {
        clamp->addAction(text, &bench.simulation, [&bench, gon = gon] { bench.simulation.turnCamera(core::Angle::fromGon(gon)); });
    }
}

void addLineSettings(QMenu& menu, app::Workbench& bench) {
    QMenu* const settings = menu.addMenu(QObject::tr("Line setting of the instrument"));
    const std::pair<QString, QString> all[] = {{{}, QObject::tr("Understands every setting")},
                                               {QStringLiteral("9600-8N1"), QObject::tr("9600 8N1 only")},
                                               {QStringLiteral("4800-8N1"), QObject::tr("4800 8N1 only")},
                                               {QStringLiteral("2400-7O1"), QObject::tr("2400 7O1 only")}};
    for (const auto& [setting, text] : all) {
        QAction* const action = settings->addAction(text);
        action->setCheckable(true);
        QObject::connect(action, &QAction::triggered, &bench.connection, [&bench, setting = setting] {
            app::SimulationChoice choice = bench.connection.simulation();
            choice.line = setting;
            bench.connection.restartSimulation(choice);
        });
        QObject::connect(settings, &QMenu::aboutToShow, action, [&bench, action, setting = setting] {
            action->setChecked(bench.connection.simulation().line == setting);
        });
    }
}

}  // namespace

void addLineTools(QMenu& menu, app::Workbench& bench) {
    menu.addSeparator();
    QAction* const panel = menu.addAction(QObject::tr("Control unit on a second port"));
    panel->setCheckable(true);
    QObject::connect(panel, &QAction::triggered, &bench.simulation, &app::SimulationDesk::plugPanel);
    QObject::connect(&bench.simulation, &app::SimulationDesk::panelPlugged, panel,
                     [panel](const QString& port_path) { panel->setChecked(!port_path.isEmpty()); });
    addLineSettings(menu, bench);
}

void addLaboratoryTools(QMenu& menu, app::Workbench& bench) {
    menu.addSeparator();
    addScenes(menu, bench);
    addEyepiece(menu, bench);
    addClamp(menu, bench);
    menu.addSeparator();
}

void addSimulatedBus(QMenu& menu, app::Workbench& bench, QObject& owner) {
    auto* const bus = new app::BusSimulationDesk(&owner);
    QObject::connect(bus, &app::BusSimulationDesk::started, &bench.instrument, [&bench](const QString& port_path) {
        app::SerialChoice choice;
        choice.path = port_path;
        choice.dialect = instrument::LineDialect::kBus;
        bench.instrument.connectSerial(choice);
    });
    QObject::connect(bus, &app::BusSimulationDesk::problemReported, &bench.messages,
                     [&bench](const core::Error& error) { bench.messages.report(error); });
    QObject::connect(&bench.live, &app::LivePresenter::sceneChanged, bus,
                     [&bench, bus, counted = std::uint64_t{0}]() mutable {
                         const camera::FramePtr& frame = bench.live.scene().frame;
                         if (frame && std::exchange(counted, frame->sequence) != frame->sequence) {
                             bus->countFrame();
                         }
                     });
    const auto add = [&menu, bus](const QString& text, double failure_per_frame) {
        menu.addAction(text, bus, [bus, failure_per_frame] {
            bus->setVideoSensitivity(failure_per_frame);
            bus->start();
        });
    };
    add(QObject::tr("Connect the base on its bus"), 0.0);
    add(QObject::tr("Connect a base whose start-up the video disturbs"), kDisturbedByAPicture);
}

}  // namespace pmts::gui
