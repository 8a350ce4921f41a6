#include "probe_panel.hpp"

#include "parts/lab_parts.hpp"
#include "parts/state_lamp.hpp"

#include <QListWidget>
#include <QProgressBar>
#include <QSet>

namespace pmts::gui {
namespace {

constexpr int kRow_px = 32;
constexpr int kShownRows = 3;
constexpr int kLeastRows = 2;  ///< where the checks need the room
constexpr int kVerdictLines = 3;
constexpr int kSteps = 1000;

}  // namespace

ProbePanel::ProbePanel(app::ProbePresenter& probe, QWidget* parent)
    : QGroupBox(tr("Look for the settings"), parent),
      probe_(probe),
      ports_(new QListWidget(this)),
      start_(labButton({}, "probe_start", this)),
      progress_(new QProgressBar(this)),
      lamp_(new StateLamp(this)),
      verdict_(labText("probe_verdict", this)),
      use_(labButton(tr("Use these settings"), "probe_use", this)) {
    ports_->setObjectName(QStringLiteral("probe_ports"));
    ports_->setAccessibleName(tr("Ports to look at"));
    ports_->setMinimumHeight(kLeastRows * kRow_px + 2 * ports_->frameWidth());
    ports_->setMaximumHeight(kShownRows * kRow_px + 2 * ports_->frameWidth());
    progress_->setObjectName(QStringLiteral("probe_progress"));
    progress_->setRange(0, kSteps);
    progress_->setTextVisible(false);  // the sentence below says it
    QSizePolicy policy = progress_->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(policy);
    verdict_->setMinimumHeight(kVerdictLines * fontMetrics().lineSpacing());
    verdict_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* const buttons = new QHBoxLayout;
    buttons->addWidget(start_, 1);
    buttons->addWidget(use_, 1);
    auto* const said = new QHBoxLayout;
    said->addWidget(lamp_, 0, Qt::AlignTop);
    said->addWidget(verdict_, 1);
    auto* const column = new QVBoxLayout(this);
    column->addWidget(ports_);
    column->addLayout(buttons);
    column->addWidget(progress_);
    column->addLayout(said);
    connect(start_, &QPushButton::clicked, this, &ProbePanel::startOrCancel);
    connect(use_, &QPushButton::clicked, &probe_, &app::ProbePresenter::useFound);
    connect(&probe_, &app::ProbePresenter::changed, this, &ProbePanel::showProbe);
    showPorts();
    showProbe();
}

void ProbePanel::showPorts() {
    QSet<QString> left_out;
    for (int row = 0; row < ports_->count(); ++row) {
        if (ports_->item(row)->checkState() != Qt::Checked) {
            left_out.insert(ports_->item(row)->data(Qt::UserRole).toString());
        }
    }
    ports_->clear();
    for (const app::PortChoice& port : probe_.ports()) {
        auto* const item = new QListWidgetItem(port.name, ports_);
        item->setData(Qt::UserRole, port.path);
        item->setSizeHint({0, kRow_px});
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
        item->setCheckState(left_out.contains(port.path) ? Qt::Unchecked : Qt::Checked);
    }
}

void ProbePanel::startOrCancel() {
    if (probe_.isRunning()) {
        probe_.cancel();
        return;
    }
    QStringList paths;
    for (int row = 0; row < ports_->count(); ++row) {
        if (ports_->item(row)->checkState() == Qt::Checked) {
            paths.append(ports_->item(row)->data(Qt::UserRole).toString());
        }
    }
    probe_.start(paths);
}

void ProbePanel::showProbe() {
    const bool running = probe_.isRunning();
    const QString refusal = probe_.refusal();
    start_->setText(running ? tr("Cancel") : tr("Look for the instrument"));
    start_->setEnabled(running || refusal.isEmpty());
    start_->setToolTip(refusal);
    use_->setEnabled(!running && refusal.isEmpty() && probe_.found().has_value());
    ports_->setEnabled(!running);
    progress_->setVisible(running);
    progress_->setValue(static_cast<int>(probe_.fraction() * kSteps));
    if (running) {
        lamp_->setState(app::DeviceState::kBusy);
        verdict_->setText(probe_.stepText().isEmpty() ? tr("The port is being freed.")
                                                      : tr("Asking on %1.").arg(probe_.stepText()));
        return;
    }
    const app::StatusItem& verdict = probe_.verdict();
    const bool said = !verdict.text.isEmpty();
    lamp_->setState(verdict.state);
    verdict_->setText(said && refusal.isEmpty() ? QStringLiteral("%1 %2").arg(verdict.text, verdict.details)
                      : refusal.isEmpty()
                          ? tr("Tries 9600 8N1, then the other speeds and framings, with a harmless question.")
                          : refusal);
}

}  // namespace pmts::gui
