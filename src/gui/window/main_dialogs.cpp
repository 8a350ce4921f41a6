#include "field/aiming_dialog.hpp"
#include "field/evidence_dialog.hpp"
#include "field/field_actions.hpp"
#include "field/field_workspace.hpp"
#include "pmts/gui/main_window.hpp"
#include "small_dialogs.hpp"
#include "field/station_dialog.hpp"
#include "ui_main_window.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

namespace pmts::gui {

void MainWindow::openStation() {
    if (station_ == nullptr) {
        station_ = new StationDialog(bench_.station, bench_.instrument, bench_.preferences, this);
    }
    station_->show();
    station_->raise();
    station_->activateWindow();
}

void MainWindow::openStep() {
    auto* const dialog = new StepDialog(bench_.targeting.stepText(), bench_.preferences.units(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &StepDialog::stepChosen, &bench_.targeting, &app::TargetingPresenter::setStepText);
    connect(&bench_.targeting, &app::TargetingPresenter::stepRejected, dialog, &StepDialog::showRejection);
    dialog->open();
}

void MainWindow::openAim() {
    auto* const dialog = new AimDialog(bench_.preferences.units(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, &bench_.targeting,
            [this, dialog] { bench_.targeting.aimAtText(dialog->haText(), dialog->vaText()); });
    dialog->open();
}

void MainWindow::openAiming() {
    if (aiming_ == nullptr) {
        aiming_ = new AimingDialog(bench_.aiming, bench_.preferences, this);
    }
    aiming_->show();
    aiming_->raise();
    aiming_->activateWindow();
}

void MainWindow::openUnits() {
    auto* const dialog = new UnitsDialog(bench_.preferences.units(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, &bench_.preferences,
            [this, dialog] { bench_.preferences.setUnits(dialog->units()); });
    dialog->open();
}

void MainWindow::openKeys() {
    auto* const dialog = new KeysDialog(actions_->withKeys(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

void MainWindow::openAbout() {
    auto* const dialog = new AboutDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::chooseNewJob() {
    const QString path = QFileDialog::getSaveFileName(
        this, tr("New job"), QFileInfo(bench_.job.path()).path(), tr("PMTS job (*.gpkg)"));
    if (!path.isEmpty()) {
        bench_.job.createJob(path.endsWith(QStringLiteral(".gpkg")) ? path : path + QStringLiteral(".gpkg"));
    }
}

void MainWindow::chooseJob() {
    const QString path = QFileDialog::getOpenFileName(
        this, tr("Open job"), QFileInfo(bench_.job.path()).path(), tr("PMTS job (*.gpkg)"));
    if (!path.isEmpty()) {
        bench_.job.openJob(path);
    }
}

void MainWindow::chooseExport() {
    const QFileInfo job(bench_.job.path());
    auto* const dialog = new ExportDialog(QStringLiteral("%1/%2.csv").arg(job.path(), job.completeBaseName()),
                                          app::JobPresenter::exportFilter(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, &bench_.job, [this, dialog] { bench_.job.exportTo(dialog->path()); });
    dialog->open();
}

void MainWindow::choosePlanned() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Import planned points"), QFileInfo(bench_.job.path()).path(),
                                     app::PlannedPointsModel::importFilter());
    if (!path.isEmpty()) {
        bench_.planned.importFrom(path);
        field_->showPage(field_->plannedDock());
    }
}

void MainWindow::openEvidence() {
    if (evidence_ == nullptr) {
        evidence_ = new EvidenceDialog(bench_.evidence, this);
    }
    evidence_->setFolder(QFileInfo(bench_.job.path()).path());
    evidence_->show();
    evidence_->raise();
    evidence_->activateWindow();
}

void MainWindow::fillRecentJobs(QMenu* menu) {
    for (const QString& path : bench_.job.recentJobs()) {
        menu->addAction(path, this, [this, path] { bench_.job.openJob(path); });
    }
}

}  // namespace pmts::gui
