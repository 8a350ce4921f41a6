#include "control_page.hpp"

#include "parts/lab_parts.hpp"
#include "path_switch_box.hpp"
#include "port_form.hpp"
#include "parts/state_lamp.hpp"

#include <QGridLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QShortcut>
#include <QTableWidget>

#include <chrono>

namespace pmts::gui {
namespace {

using namespace std::chrono_literals;

constexpr auto kTick = 500ms;
constexpr int kMode_px = 64;
constexpr double kModeFont = 1.4;
constexpr int kMargin_px = 12;
constexpr int kNumber_px = 130;

}  // namespace

ControlPage::ControlPage(app::Workbench& bench, QWidget* parent)
    : ListedPage(parent),
      connection_(bench.connection),
      control_(bench.control),
      change_lamp_(new StateLamp(this)),
      change_(labText("control_change", this)),
      cancel_(labButton(tr("Cancel"), "control_cancel", this)),
      owner_lamp_(new StateLamp(this)),
      owner_(labText("control_owner", this)),
      path_switch_(new PathSwitchBox(this)) {
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kMargin_px);
    auto* const modes = new QGridLayout;
    addModes(*modes);
    column->addLayout(modes);
    column->addLayout(ownerRow());
    auto* const left_side = new QVBoxLayout;
    left_side->addWidget(panelBox());
    left_side->addWidget(path_switch_);
    left_side->addStretch(1);
    auto* const sides = new QHBoxLayout;
    sides->addLayout(left_side, 1);
    sides->addWidget(countersBox(), 1);
    column->addLayout(sides, 1);
    tick_.setInterval(kTick);
    connect(&tick_, &QTimer::timeout, this, [this] {
        showOwner();
        showCounters();
    });
    connect(&control_, &app::ControlPresenter::modeChanged, this, &ControlPage::showMode);
    connect(&control_, &app::ControlPresenter::shownOwnerChanged, this, &ControlPage::showOwner);
    connect(&control_, &app::ControlPresenter::panelPortChanged, this, &ControlPage::showPanel);
    connect(&connection_, &app::ConnectionPresenter::portsChanged, this, [this] { port_->setPorts(connection_.ports()); });
    connect(cancel_, &QPushButton::clicked, this, [this] { control_.setMode(control_.mode()); });
    connect(path_switch_, &PathSwitchBox::chosen, &control_, &app::ControlPresenter::setPathSwitch);
    showMode();
    showPanel();
    showCounters();
}

void ControlPage::addModes(QGridLayout& grid) {
    grid.setRowMinimumHeight(0, kMode_px);
    for (const auto mode : app::ControlPresenter::modes()) {
        const auto index = static_cast<int>(modes_.size());
        const QString key = QString::number(index + 1);
        auto* const button =
            labButton(QStringLiteral("%1   %2").arg(app::ControlPresenter::modeName(mode), key), "control_mode", this);
        button->setObjectName(QStringLiteral("control_mode_%1").arg(key));
        button->setAccessibleName(app::ControlPresenter::modeName(mode));
        button->setCheckable(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
        QFont font = button->font();
        font.setPointSizeF(font.pointSizeF() * kModeFont);
        button->setFont(font);
        const auto choose = [this, mode] {
            control_.setMode(mode);
            showMode();  // a click on the checked one unchecks it
        };
        connect(button, &QPushButton::clicked, this, choose);
        auto* const shortcut = new QShortcut(QKeySequence(key), this);
        shortcut->setEnabled(false);
        connect(shortcut, &QShortcut::activated, this, choose);
        auto* const help = labText("control_help", this);
        help->setText(app::ControlPresenter::modeHelp(mode));
        help->setAlignment(Qt::AlignTop | Qt::AlignHCenter);
        grid.addWidget(button, 0, index);
        grid.addWidget(help, 1, index);
        grid.setColumnStretch(index, 1);
        modes_.push_back(button);
        keys_.push_back(shortcut);
    }
}

QLayout* ControlPage::ownerRow() {
    auto* const row = new QHBoxLayout;
    QFont font = owner_->font();
    font.setPointSizeF(font.pointSizeF() * kModeFont);
    font.setBold(true);
    owner_->setFont(font);
    owner_->setWordWrap(false);
    row->addWidget(owner_lamp_);
    row->addWidget(owner_);
    row->addSpacing(2 * kMargin_px);
    row->addWidget(change_lamp_);
    row->addWidget(change_, 1);
    row->addWidget(cancel_);
    for (QWidget* const widget : {static_cast<QWidget*>(change_lamp_), static_cast<QWidget*>(cancel_)}) {
        QSizePolicy policy = widget->sizePolicy();
        policy.setRetainSizeWhenHidden(true);  // nothing jumps when a change begins
        widget->setSizePolicy(policy);
    }
    return row;
}

QGroupBox* ControlPage::panelBox() {
    auto* const box = new QGroupBox(tr("Panel on a second port"), this);
    panel_lamp_ = new StateLamp(box);
    panel_ = labText("control_panel", box);
    port_ = new PortForm(box);
    auto* const use = labButton(tr("Use this port"), "control_use_panel", box);
    remove_ = labButton(tr("Remove the panel"), "control_remove_panel", box);
    auto* const state = new QHBoxLayout;
    state->addWidget(panel_lamp_, 0, Qt::AlignTop);
    state->addWidget(panel_, 1);
    auto* const buttons = new QHBoxLayout;
    buttons->addWidget(use, 1);
    buttons->addWidget(remove_, 1);
    auto* const column = new QVBoxLayout(box);
    column->addLayout(state);
    column->addWidget(port_);
    column->addLayout(buttons);
    connect(port_, &PortForm::lookAgainRequested, &connection_, &app::ConnectionPresenter::refreshPorts);
    connect(use, &QPushButton::clicked, this, [this] { control_.usePanel(port_->choice()); });
    connect(remove_, &QPushButton::clicked, &control_, &app::ControlPresenter::removePanel);
    return box;
}

QGroupBox* ControlPage::countersBox() {
    auto* const box = new QGroupBox(tr("Since the line was opened"), this);
    counters_ = new QTableWidget(0, 2, box);
    counters_->setObjectName(QStringLiteral("control_counters"));
    counters_->setAccessibleName(tr("Counters"));
    counters_->horizontalHeader()->hide();
    counters_->verticalHeader()->hide();
    counters_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    counters_->setColumnWidth(1, kNumber_px);
    counters_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    counters_->setSelectionMode(QAbstractItemView::NoSelection);
    counters_->setFocusPolicy(Qt::NoFocus);
    auto* const column = new QVBoxLayout(box);
    column->addWidget(counters_);
    return box;
}

void ControlPage::entered() {
    if (connection_.ports().empty()) {
        connection_.refreshPorts();
    }
    for (QShortcut* const key : keys_) {
        key->setEnabled(true);
    }
    showOwner();
    showCounters();
    tick_.start();
}

void ControlPage::left() {
    tick_.stop();
    for (QShortcut* const key : keys_) {
        key->setEnabled(false);
    }
}

void ControlPage::showMode() {
    const auto modes = app::ControlPresenter::modes();
    for (std::size_t i = 0; i < modes.size(); ++i) {
        modes_[i]->setChecked(modes[i] == control_.wantedMode());
    }
    const QString reason = control_.changeReason();
    change_->setText(reason);
    change_lamp_->setState(app::DeviceState::kBusy);
    change_lamp_->setVisible(!reason.isEmpty());
    cancel_->setVisible(!reason.isEmpty());
    path_switch_->showSwitch(control_.settings().path_switch);
    showOwner();
}

void ControlPage::showOwner() {
    const app::StatusItem owner = control_.ownerLamp();
    owner_lamp_->setState(owner.state);
    owner_->setText(owner.text);
    Q_EMIT stateChanged(control_.barItem().state);
}

void ControlPage::showPanel() {
    const app::StatusItem panel = control_.panelPort();
    panel_lamp_->setState(panel.state);
    panel_->setText(QStringLiteral("%1. %2").arg(panel.text, panel.details));
    const auto port = control_.settings().panel;
    remove_->setEnabled(port.has_value());
    if (port) {
        port_->showChoice(*port);
    }
    showOwner();
}

void ControlPage::showCounters() {
    const auto counters = control_.counters();
    counters_->setRowCount(static_cast<int>(counters.size()));
    for (int row = 0; row < counters_->rowCount(); ++row) {
        const app::ControlCounter& counter = counters[static_cast<std::size_t>(row)];
        if (counters_->item(row, 0) == nullptr) {
            counters_->setItem(row, 0, new QTableWidgetItem(counter.name));
            counters_->setItem(row, 1, new QTableWidgetItem);
            counters_->item(row, 1)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        }
        counters_->item(row, 1)->setText(counter.value);
    }
}

}  // namespace pmts::gui
