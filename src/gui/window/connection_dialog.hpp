#pragma once

#include "pmts/app/desk/workbench.hpp"

#include <QDialog>

#include <memory>

class QPushButton;

namespace Ui {
class ConnectionDialog;
}

namespace pmts::gui {

class ProbePanel;

/// The connection page: instrument with its port and identification, the doctor, cameras, rig profiles.
class ConnectionDialog : public QDialog {
    Q_OBJECT
public:
    enum class Page { kInstrument, kCamera, kRig };

    explicit ConnectionDialog(app::Workbench& bench, QWidget* parent = nullptr);
    ~ConnectionDialog() override;

    void openPage(Page page);

Q_SIGNALS:
    void formatRequested();
    void controlRequested();  ///< the page of who has control

private:
    void wireInstrument();
    void wireDoctor(app::Workbench& bench);
    void wireControl(app::ControlPresenter& control);
    void wireCamera(app::LivePresenter& live);
    void wireRig();
    void showPorts();
    void connectChosen();
    void showStatus(const app::StatusItem& status);
    void showIdentity();
    void showDoctor();
    void showCameras();
    void showCameraStatus(const app::StatusItem& status);
    void showRigs();
    void openStream();
    void importRig();
    void exportRig();

    app::ConnectionPresenter& connection_;
    std::unique_ptr<Ui::ConnectionDialog> ui_;
    ProbePanel* probe_ = nullptr;
    QPushButton* switch_on_ = nullptr;
};

}  // namespace pmts::gui
