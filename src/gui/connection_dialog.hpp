#pragma once

#include "pmts/app/connection_presenter.hpp"

#include <QDialog>

#include <memory>

namespace Ui {
class ConnectionDialog;
}

namespace pmts::gui {

/// The connection page: instrument with its port and identification, the doctor, cameras, rig profiles.
class ConnectionDialog : public QDialog {
    Q_OBJECT
public:
    enum class Page { kInstrument, kCamera, kRig };

    ConnectionDialog(app::ConnectionPresenter& connection, app::LivePresenter& live,
                     QWidget* parent = nullptr);
    ~ConnectionDialog() override;

    void openPage(Page page);

Q_SIGNALS:
    void formatRequested();

private:
    void wireInstrument();
    void wireCamera(app::LivePresenter& live);
    void wireRig();
    void showPorts();
    void showStatus(const app::StatusItem& status);
    void showIdentity();
    void showDoctor();
    void showCameras();
    void showCameraStatus(const app::StatusItem& status);
    void showRigs();
    void connectChosen();
    void openStream();
    void importRig();
    void exportRig();
    [[nodiscard]] app::SerialChoice chosenSerial() const;

    app::ConnectionPresenter& connection_;
    std::unique_ptr<Ui::ConnectionDialog> ui_;
};

}  // namespace pmts::gui
