#include "camera_actions.hpp"

#include "field/field_actions.hpp"
#include "vidformat_dialog.hpp"

#include <QFileDialog>
#include <QProgressDialog>

namespace pmts::gui {
namespace {

constexpr int kProgress_px = 360;
constexpr int kPatience_ms = 400;  ///< a short export shows no dialog

}  // namespace

CameraActions::CameraActions(const FieldActions& actions, app::Workbench& bench, QWidget* window)
    : QObject(window), actions_(actions), bench_(bench), window_(window) {
    app::CameraPresenter& camera = bench_.camera;
    connect(actions_.pause_camera, &QAction::triggered, &camera, [this, &camera] {
        camera.togglePause();
        showState();
    });
    connect(actions_.stop_camera, &QAction::triggered, &camera, &app::CameraPresenter::stop);
    connect(actions_.video_format, &QAction::triggered, this, &CameraActions::openFormat);
    connect(actions_.export_photos, &QAction::triggered, this, &CameraActions::chooseFolder);
    connect(&bench_.photo_export, &app::PhotoExport::progressed, this, &CameraActions::showExport);
    connect(&camera, &app::CameraPresenter::stateChanged, this, &CameraActions::showState);
    showState();
}

void CameraActions::openFormat() {
    if (format_ == nullptr) {
        format_ = new VidformatDialog(bench_.camera, window_);
    }
    format_->show();
    format_->raise();
    format_->activateWindow();
}

void CameraActions::chooseFolder() {
    const QString folder = QFileDialog::getExistingDirectory(window_, tr("Export photos"), QFileInfo(bench_.job_desk.path()).path());
    if (!folder.isEmpty()) {
        bench_.photo_export.exportTo(folder);
    }
}

/// Modeless: the work goes on while the photos are written.
void CameraActions::showExport() {
    const app::PhotoExport& photos = bench_.photo_export;
    if (progress_ == nullptr) {
        progress_ = new QProgressDialog(window_);
        progress_->setObjectName(QStringLiteral("photo_export"));
        progress_->setWindowTitle(tr("Export photos"));
        progress_->setAutoReset(false);
        progress_->setMinimumDuration(kPatience_ms);
        progress_->setMinimumWidth(kProgress_px);
        progress_->reset();  // or it shows itself once the time is over
        connect(progress_, &QProgressDialog::canceled, &bench_.photo_export, &app::PhotoExport::cancel);
    }
    if (!photos.isRunning()) {
        return progress_->reset();
    }
    progress_->setLabelText(photos.count() == 0 ? tr("Looking for the photos of the job")
                                                : tr("Photo %1 of %2").arg(photos.done() + 1).arg(photos.count()));
    progress_->setMaximum(static_cast<int>(photos.count()));
    progress_->setValue(static_cast<int>(photos.done()));
}

void CameraActions::showState() {
    const app::CameraPresenter& camera = bench_.camera;
    actions_.pause_camera->setEnabled(camera.hasCamera());
    actions_.pause_camera->setChecked(camera.hasCamera() && !camera.isRunning());
    actions_.stop_camera->setEnabled(camera.isRunning() || camera.isPaused());
}

}  // namespace pmts::gui
