#include "camera_actions.hpp"

#include "field_actions.hpp"
#include "vidformat_dialog.hpp"

#include <QFileDialog>

namespace pmts::gui {

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

void CameraActions::showState() {
    const app::CameraPresenter& camera = bench_.camera;
    actions_.pause_camera->setEnabled(camera.hasCamera());
    actions_.pause_camera->setChecked(camera.hasCamera() && !camera.isRunning());
    actions_.stop_camera->setEnabled(camera.isRunning() || camera.isPaused());
}

}  // namespace pmts::gui
