#include "connection_dialog.hpp"

#include "ui_connection_dialog.h"

#include <QFileDialog>

namespace pmts::gui {
namespace {

struct Framing {
    int data_bits;
    app::Parity parity;
    int stop_bits;
    const char* text;
};

constexpr Framing kFramings[] = {{8, app::Parity::kNone, 1, "8N1"},
                                 {7, app::Parity::kEven, 1, "7E1"},
                                 {7, app::Parity::kOdd, 1, "7O1"},
                                 {8, app::Parity::kEven, 1, "8E1"},
                                 {8, app::Parity::kNone, 2, "8N2"}};

}  // namespace

ConnectionDialog::ConnectionDialog(app::ConnectionPresenter& connection, app::LivePresenter& live,
                                   QWidget* parent)
    : QDialog(parent), connection_(connection), ui_(std::make_unique<Ui::ConnectionDialog>()) {
    ui_->setupUi(this);
    wireInstrument();
    wireCamera(live);
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
    for (const int baud : app::ConnectionPresenter::baudRates()) {
        ui_->baud->addItem(QString::number(baud), baud);
    }
    for (const Framing& framing : kFramings) {
        ui_->framing->addItem(QString::fromLatin1(framing.text));
    }
    ui_->dialect->addItem(tr("External interface (foot)"), static_cast<int>(instrument::LineDialect::kExternal));
    ui_->dialect->addItem(tr("Bus under the panel"), static_cast<int>(instrument::LineDialect::kBus));
    ui_->dialect->setToolTip(tr("On the bus the angles come by themselves and everything else is a routine of the instruction table."));
    connect(ui_->refresh, &QPushButton::clicked, &connection_, &app::ConnectionPresenter::refresh);
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

void ConnectionDialog::showPorts() {
    const app::SerialChoice last = connection_.serialChoice();
    ui_->port->clear();
    for (const app::PortChoice& port : connection_.ports()) {
        ui_->port->addItem(port.used_last ? tr("%1 (last used)").arg(port.name) : port.name, port.path);
    }
    const int index = ui_->port->findData(last.path);
    ui_->port->setCurrentIndex(index);
    if (index < 0) {
        ui_->port->setEditText(last.path);
    }
    ui_->baud->setCurrentIndex(ui_->baud->findData(last.baud));
    ui_->dialect->setCurrentIndex(ui_->dialect->findData(static_cast<int>(last.dialect)));
    for (const Framing& framing : kFramings) {
        if (framing.data_bits == last.data_bits && framing.parity == last.parity &&
            framing.stop_bits == last.stop_bits) {
            ui_->framing->setCurrentIndex(static_cast<int>(&framing - kFramings));
        }
    }
}

app::SerialChoice ConnectionDialog::chosenSerial() const {
    app::SerialChoice choice = connection_.serialChoice();
    const int index = ui_->port->currentIndex();
    const bool picked = index >= 0 && ui_->port->currentText() == ui_->port->itemText(index);
    choice.path = picked ? ui_->port->itemData(index).toString() : ui_->port->currentText().trimmed();
    choice.adapter =
        picked ? connection_.ports().at(static_cast<std::size_t>(index)).adapter : decltype(choice.adapter){};
    choice.baud = ui_->baud->currentData().toInt();
    choice.dialect = static_cast<instrument::LineDialect>(ui_->dialect->currentData().toInt());
    const Framing& framing = kFramings[std::max(0, ui_->framing->currentIndex())];
    choice.data_bits = framing.data_bits;
    choice.parity = framing.parity;
    choice.stop_bits = framing.stop_bits;
    return choice;
}

void ConnectionDialog::connectChosen() { connection_.connectSerial(chosenSerial()); }

void ConnectionDialog::showStatus(const app::StatusItem& status) {
    ui_->lamp->setState(status.state);
    ui_->status->setText(
        status.details.isEmpty() ? status.text : QStringLiteral("%1: %2").arg(status.text, status.details));
    ui_->disconnect->setEnabled(status.state != app::DeviceState::kIdle);
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
    ui_->doctor->setHtml(
        number > 0
            ? page
            : tr("<p>The instrument answers. If it ever does not, this page says what to set on it.</p>"));
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
