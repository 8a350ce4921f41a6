#include "top_bar.hpp"

#include "parts/line_icon.hpp"
#include "parts/state_lamp.hpp"
#include "ui_top_bar.h"

namespace pmts::gui {

TopBar::TopBar(QWidget* parent) : QWidget(parent), ui_(std::make_unique<Ui::TopBar>()) {
    ui_->setupUi(this);
    setAttribute(Qt::WA_StyledBackground);
    connect(ui_->job, &QToolButton::clicked, this, &TopBar::jobClicked);
    connect(ui_->station, &QToolButton::clicked, this, &TopBar::stationClicked);
    connect(ui_->instrument, &QToolButton::clicked, this, &TopBar::instrumentClicked);
    connect(ui_->camera, &QToolButton::clicked, this, &TopBar::cameraClicked);
    connect(ui_->control, &QToolButton::clicked, this, &TopBar::controlClicked);
    connect(ui_->gate, &QToolButton::clicked, this, &TopBar::gateClicked);
}

TopBar::~TopBar() = default;

void TopBar::showItem(QToolButton* button, const app::StatusItem& item, const QString& name) {
    if (button->text() != item.text || button->icon().isNull() ||
        button->property("state").toInt() != static_cast<int>(item.state)) {
        button->setText(item.text);
        button->setIcon(lampIcon(item.state));
        button->setProperty("state", static_cast<int>(item.state));
        button->setAccessibleName(QStringLiteral("%1: %2, %3").arg(name, item.text, lampText(item.state)));
    }
    button->setToolTip(item.details);
    button->setVisible(!item.text.isEmpty());
}

void TopBar::showLine(const app::StatusLine& line) {
    app::StatusItem job = line.job;
    job.text = tr("Job: %1").arg(job.text);
    showItem(ui_->job, job, tr("Job"));
    showItem(ui_->station, line.station, tr("Station"));
    showItem(ui_->instrument, line.instrument, tr("Instrument"));
    showItem(ui_->camera, line.camera, tr("Camera"));
    showItem(ui_->control, line.control, tr("Control"));
    showItem(ui_->gate, line.gate, tr("Video pauses"));
}

}  // namespace pmts::gui
