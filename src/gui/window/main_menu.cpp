#include "field/field_actions.hpp"
#include "field/field_workspace.hpp"
#include "field/method_tools.hpp"
#include "simulated_hands.hpp"
#include "pmts/gui/main_window.hpp"
#include "ui_main_window.h"

#include <QDockWidget>
#include <QMenu>

namespace pmts::gui {

void MainWindow::buildMenus() {
    const FieldActions& a = *actions_;
    buildFileMenu();
    QMenu* const edit = ui_->menu_bar->addMenu(tr("&Edit"));
    QAction* const undo = bench_.undo.createUndoAction(edit, tr("Undo"));
    QAction* const redo = bench_.undo.createRedoAction(edit, tr("Redo"));
    undo->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Z));
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    edit->addActions({undo, redo});
    edit->addSeparator();
    edit->addActions({a.edit_point, a.evidence});
    QMenu* const measure = ui_->menu_bar->addMenu(tr("&Measure"));
    measure->addActions({a.capture, a.move, a.measure, a.convert, a.record, a.all, a.record_again});
    measure->addSeparator();
    measure->addActions({a.aim, a.move_open, a.change_face, a.clear_target});
    measure->addSeparator();
    measure->addActions({a.recentre, a.click_turns, a.aiming});
    measure->addSeparator();
    measure->addActions({a.left, a.right, a.up, a.down, a.step});
    measure->addSeparator();
    measure->addAction(a.stop);
    QMenu* const instrument = ui_->menu_bar->addMenu(tr("&Instrument"));
    instrument->addActions({a.connection, a.station});
    instrument->addSeparator();
    instrument->addActions({a.pause_camera, a.stop_camera, a.video_format});
    buildSimulatorMenu();
    buildViewMenu();
    QMenu* const tools = ui_->menu_bar->addMenu(tr("Too&ls"));
    addMethodTools(*tools, bench_, this);
    QMenu* const settings = ui_->menu_bar->addMenu(tr("&Settings"));
    settings->addActions({a.units, a.sounds});
    QMenu* const help = ui_->menu_bar->addMenu(tr("&Help"));
    help->addActions({a.keys, a.bug_report, a.about});
}

void MainWindow::buildFileMenu() {
    QMenu* const file = ui_->menu_bar->addMenu(tr("&File"));
    file->addActions({actions_->new_job, actions_->open_job});
    QMenu* const recent = file->addMenu(tr("Recent jobs"));
    connect(recent, &QMenu::aboutToShow, this, [this, recent] {
        recent->clear();
        fillRecentJobs(recent);
    });
    file->addActions({actions_->export_points, actions_->export_photos, actions_->import_planned});
    file->addSeparator();
    file->addActions({actions_->open_black_box, actions_->quit});
}

void MainWindow::buildViewMenu() {
    const FieldActions& a = *actions_;
    QMenu* const view = ui_->menu_bar->addMenu(tr("&View"));
    view->addActions({a.field, a.lab, a.line});
    view->addSeparator();
    for (const QDockWidget* dock : field_->docks()) {
        view->addAction(dock->toggleViewAction());
    }
    view->addSeparator();
    view->addActions({a.focus, a.zoom_in, a.zoom_out, a.fit});
    view->addSeparator();
    view->addActions({a.snap, a.drag_turns, a.zoom_box, a.mark, a.range});
    view->addSeparator();
    view->addActions({a.day, a.night, a.sun});
    view->addSeparator();
    view->addActions({a.larger_text, a.smaller_text});
}

void MainWindow::buildSimulatorMenu() {
    QMenu* const menu = ui_->menu_bar->addMenu(tr("Simula&tor"));
    app::SimulationDesk& simulation = bench_.simulation;
    menu->addAction(tr("Press the REG key"), &simulation, &app::SimulationDesk::pressRegKey);
    menu->addAction(tr("Pull the cable"), &simulation, &app::SimulationDesk::unplug);
    menu->addAction(tr("Plug the cable in again"), &simulation, &app::SimulationDesk::plugIn);
    addLineTools(*menu, bench_);
    addLaboratoryTools(*menu, bench_);
    addSimulatedBus(*menu, bench_, *this);
    QMenu* const faults = menu->addMenu(tr("Fault"));
    for (const QString& fault : app::SimulationDesk::faultNames()) {
        faults->addAction(fault, &simulation, [&simulation, fault] { simulation.injectFault(fault); });
    }
}

}  // namespace pmts::gui
