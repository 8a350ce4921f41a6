#include "connection_dialog.hpp"

#include "line/check_list.hpp"
#include "parts/lab_parts.hpp"
#include "line/probe_panel.hpp"
#include "ui_connection_dialog.h"

#include <QFileDialog>

namespace pmts::gui {

ConnectionDialog::ConnectionDialog(app::Workbench& bench, QWidget* parent)
    : QDialog(parent), connection_(bench.connection), ui_(std::make_unique<Ui::ConnectionDialog>()) {
    ui_->setupUi(this);
    wireInstrument();
    wireDoctor(bench);
    wireControl(bench.control);
    wireCamera(bench.live);
    wireRig();
}

ConnectionDialog::~ConnectionDialog() = default;

void ConnectionDialog::openPage(Page page) {
    connection_.refresh();
    ui_->tabs->setCurrentIndex(static_cast<int>(page));
    show();
    raise();
    activateWindow();
}

void ConnectionDialog::wireInstrument() {
    connect(ui_->port_form, &PortForm::lookAgainRequested, &connection_, &app::ConnectionPresenter::refresh);
    ui_->dialect->addItem(tr("External interface (foot)"), static_cast<int>(instrument::LineDialect::kExternal));
    ui_->dialect->addItem(tr("Bus under the panel"), static_cast<int>(instrument::LineDialect::kBus));
    ui_->dialect->setToolTip(tr("On the bus the angles come by themselves and everything else is a routine of the instruction table."));
    connect(ui_->connect, &QPushButton::clicked, this, &ConnectionDialog::connectChosen);
    connect(ui_->simulated, &QPushButton::clicked, &connection_, &app::ConnectionPresenter::connectSimulated);
    connect(ui_->disconnect, &QPushButton::clicked, &connection_,
            &app::ConnectionPresenter::disconnectInstrument);
    connect(&connection_, &app::ConnectionPresenter::portsChanged, this, &ConnectionDialog::showPorts);
    connect(&connection_, &app::ConnectionPresenter::instrumentStatusChanged, this,
            &ConnectionDialog::showStatus);
    connect(&connection_, &app::ConnectionPresenter::identityChanged, this, &ConnectionDialog::showIdentity);
    connect(&connection_, &app::ConnectionPresenter::doctorChanged, this, &ConnectionDialog::showDoctor);
    showPorts();
    showStatus(connection_.instrumentStatus());
    showIdentity();
    showDoctor();
}

void ConnectionDialog::wireDoctor(app::Workbench& bench) {
    probe_ = new ProbePanel(bench.probe, this);
    ui_->doctor_column->addWidget(new CheckList(bench.connection_checks, this));
    switch_on_ = labButton(tr("Switch the instrument on"), "switch_on", this);
    switch_on_->setToolTip(tr("Sends a BREAK on the port. The instrument may turn while it starts."));
    ui_->port_column->insertWidget(ui_->port_column->indexOf(ui_->doctor), switch_on_);
    ui_->doctor_column->addStretch(1);
    ui_->doctor_column->addWidget(probe_);
    connect(switch_on_, &QPushButton::clicked, &connection_, &app::ConnectionPresenter::switchOn);
    showDoctor();
    connect(&bench.simulation, &app::SimulationDesk::started, probe_, &ProbePanel::showPorts);
    connect(&bench.simulation, &app::SimulationDesk::pluggedIn, probe_, &ProbePanel::showPorts);
}

void ConnectionDialog::wireControl(app::ControlPresenter& control) {
    const auto show = [this, &control] {
        const app::StatusItem panel = control.panelPort();
        ui_->panel_lamp->setState(panel.state);
        ui_->panel->setText(QStringLiteral("%1. %2").arg(panel.text, panel.details));
    };
    connect(&control, &app::ControlPresenter::panelPortChanged, this, show);
    connect(ui_->open_control, &QPushButton::clicked, this, [this] {
        close();
        Q_EMIT controlRequested();
    });
    show();
}

void ConnectionDialog::showPorts() {
    ui_->port_form->setPorts(connection_.ports());
    ui_->port_form->showChoice(connection_.serialChoice());
    ui_->dialect->setCurrentIndex(ui_->dialect->findData(static_cast<int>(connection_.serialChoice().dialect)));
    if (probe_ != nullptr) {
        probe_->showPorts();
    }
}

void ConnectionDialog::connectChosen() {
    app::SerialChoice choice = ui_->port_form->choice();
    choice.dialect = static_cast<instrument::LineDialect>(ui_->dialect->currentData().toInt());
    connection_.connectSerial(choice);
}

void ConnectionDialog::showStatus(const app::StatusItem& status) {
    ui_->lamp->setState(status.state);
    ui_->status->setText(
        status.details.isEmpty() ? status.text : QStringLiteral("%1: %2").arg(status.text, status.details));
    ui_->disconnect->setEnabled(status.state != app::DeviceState::kIdle);
    showIdentity();
}

void ConnectionDialog::showIdentity() {
    QStringList lines;
    for (const app::IdentityLine& line : connection_.identityLines()) {
        lines.append(QStringLiteral("%1: %2").arg(line.name, line.value));
    }
    ui_->identity->setText(lines.join(u'\n'));
    ui_->identity_title->setVisible(!lines.isEmpty());
}

void ConnectionDialog::showDoctor() {
    QString page;
    int number = 0;
    for (const app::DoctorStep& step : connection_.doctorSteps()) {
        page += QStringLiteral("<p><b>%1. %2</b><br/>%3</p>")
                    .arg(++number)
                    .arg(step.title.toHtmlEscaped(), step.text.toHtmlEscaped());
    }
    ui_->doctor->setHtml(page);
    ui_->doctor->setVisible(number > 0);
    if (switch_on_ != nullptr) {
        switch_on_->setVisible(connection_.canSwitchOn());
    }
}

void ConnectionDialog::wireCamera(app::LivePresenter& live) {
    connect(ui_->camera_refresh, &QPushButton::clicked, &connection_, &app::ConnectionPresenter::refresh);
    connect(&connection_, &app::ConnectionPresenter::camerasChanged, this, &ConnectionDialog::showCameras);
    connect(&live, &app::LivePresenter::cameraStatusChanged, this, &ConnectionDialog::showCameraStatus);
    const auto use = [this] {
        const int row = ui_->cameras->currentRow();
        if (row >= 0 && static_cast<std::size_t>(row) < connection_.cameras().size()) {
            connection_.chooseCamera(connection_.cameras().at(static_cast<std::size_t>(row)));
        }
    };
    connect(ui_->use_camera, &QPushButton::clicked, this, use);
    connect(ui_->cameras, &QListWidget::itemActivated, this, use);
    connect(ui_->video_format, &QPushButton::clicked, this, &ConnectionDialog::formatRequested);
    connect(ui_->open_stream, &QPushButton::clicked, this, &ConnectionDialog::openStream);
    connect(ui_->stream, &QLineEdit::returnPressed, this, &ConnectionDialog::openStream);
    showCameras();
    showCameraStatus(live.cameraStatus());
}

void ConnectionDialog::showCameras() {
    ui_->cameras->clear();
    for (const auto& camera : connection_.cameras()) {
        ui_->cameras->addItem(camera.location.isEmpty()
                                  ? camera.name
                                  : QStringLiteral("%1   %2").arg(camera.name, camera.location));
    }
    if (const QString note = connection_.cameraListNote(); !note.isEmpty()) {
        auto* const item = new QListWidgetItem(note, ui_->cameras);
        item->setFlags(Qt::NoItemFlags);  // cannot be chosen
    }
}

void ConnectionDialog::openStream() {
    const QString location = ui_->stream->text().trimmed();
    if (location.isEmpty()) {
        return;
    }
    using Kind = decltype(video::SourceAddress::kind);
    const bool stream = location.contains(QStringLiteral("://"));
    connection_.chooseCamera(
        {.kind = stream ? Kind::kStream : Kind::kFile, .location = location, .name = location});
}

void ConnectionDialog::showCameraStatus(const app::StatusItem& status) {
    ui_->camera_lamp->setState(status.state);
    ui_->camera_status->setText(
        status.details.isEmpty() ? status.text : QStringLiteral("%1: %2").arg(status.text, status.details));
}

void ConnectionDialog::wireRig() {
    connect(ui_->rig, &QComboBox::textActivated, &connection_, &app::ConnectionPresenter::chooseRigProfile);
    connect(ui_->import_rig, &QPushButton::clicked, this, &ConnectionDialog::importRig);
    connect(ui_->export_rig, &QPushButton::clicked, this, &ConnectionDialog::exportRig);
    connect(&connection_, &app::ConnectionPresenter::rigChanged, this, &ConnectionDialog::showRigs);
    showRigs();
}

void ConnectionDialog::showRigs() {
    ui_->rig->clear();
    for (const app::RigProfile& profile : connection_.rigProfiles()) {
        ui_->rig->addItem(profile.name);
    }
    const app::RigProfile chosen = connection_.rigProfile();
    ui_->rig->setCurrentText(chosen.name);
    const QString note = connection_.rigNote();
    ui_->rig_text->setText((note.isEmpty() ? QString() : note + QStringLiteral("\n\n")) +
                           QString::fromUtf8(app::rigProfileToJson(chosen)));
}

void ConnectionDialog::importRig() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Import rig profile"), {}, tr("Rig profile (*.json)"));
    if (!path.isEmpty()) {
        connection_.importRigProfile(path);
    }
}

void ConnectionDialog::exportRig() {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Export rig profile"), {}, tr("Rig profile (*.json)"));
    if (!path.isEmpty()) {
        connection_.exportRigProfile(path);
    }
}

}  // namespace pmts::gui
