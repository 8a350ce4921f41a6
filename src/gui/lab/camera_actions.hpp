#pragma once

#include "pmts/app/desk/workbench.hpp"

#include <QObject>

class QProgressDialog;
class QWidget;

namespace pmts::gui {

class FieldActions;
class VidformatDialog;

/// Wires the actions of the camera: pause, stop, video format, export of photos. Belongs to the window.
class CameraActions : public QObject {
    Q_OBJECT
public:
    CameraActions(const FieldActions& actions, app::Workbench& bench, QWidget* window);

    void openFormat();

private:
    void chooseFolder();
    void showExport();
    void showState();

    const FieldActions& actions_;
    app::Workbench& bench_;
    QWidget* window_;
    VidformatDialog* format_ = nullptr;
    QProgressDialog* progress_ = nullptr;  ///< of the photos being exported
};

}  // namespace pmts::gui
