#include "port_form.hpp"

#include "pmts/app/desk/connection_presenter.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace pmts::gui {

PortForm::PortForm(QWidget* parent)
    : QWidget(parent), port_(new QComboBox(this)), baud_(new QComboBox(this)), framing_(new QComboBox(this)) {
    port_->setObjectName(QStringLiteral("port"));
    port_->setEditable(true);
    port_->setInsertPolicy(QComboBox::NoInsert);
    port_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    port_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    port_->setMinimumContentsLength(16);
    port_->setAccessibleName(tr("Serial port"));
    baud_->setObjectName(QStringLiteral("baud"));
    baud_->setAccessibleName(tr("Baud rate"));
    framing_->setObjectName(QStringLiteral("framing"));
    framing_->setAccessibleName(tr("Data bits, parity, stop bits"));
    for (const int baud : app::ConnectionPresenter::baudRates()) {
        baud_->addItem(QString::number(baud), baud);
    }
    for (const app::Framing& framing : app::Framing::usual()) {
        framing_->addItem(framing.text());
    }
    auto* const again = new QPushButton(tr("Look again"), this);
    again->setObjectName(QStringLiteral("refresh"));
    again->setAutoDefault(false);
    connect(again, &QPushButton::clicked, this, &PortForm::lookAgainRequested);
    auto* const label = new QLabel(tr("Port (a path may be typed)"), this);
    label->setBuddy(port_);
    auto* const line = new QHBoxLayout;
    line->addWidget(new QLabel(tr("Baud"), this));
    line->addWidget(baud_);
    line->addWidget(framing_);
    line->addStretch(1);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(label, 0, 0, 1, 2);
    grid->addWidget(port_, 1, 0);
    grid->addWidget(again, 1, 1);
    grid->addLayout(line, 2, 0, 1, 2);
    grid->setColumnStretch(0, 1);
}

void PortForm::setPorts(const std::vector<app::PortChoice>& ports) {
    const app::SerialChoice shown = choice();
    ports_ = ports;
    port_->clear();
    for (const app::PortChoice& port : ports_) {
        port_->addItem(port.used_last ? tr("%1 (last used)").arg(port.name) : port.name, port.path);
    }
    showChoice(shown);
}

void PortForm::showChoice(const app::SerialChoice& choice) {
    const int index = port_->findData(choice.path);
    port_->setCurrentIndex(index);
    if (index < 0) {
        port_->setEditText(choice.path);
    }
    baud_->setCurrentIndex(std::max(0, baud_->findData(choice.baud)));
    framing_->setCurrentText(choice.framing().text());
}

app::SerialChoice PortForm::choice() const {
    app::SerialChoice choice;
    const int index = port_->currentIndex();
    const bool is_picked = index >= 0 && port_->currentText() == port_->itemText(index);
    choice.path = is_picked ? port_->itemData(index).toString() : port_->currentText().trimmed();
    if (is_picked) {
        choice.adapter = ports_.at(static_cast<std::size_t>(index)).adapter;
    }
    choice.baud = baud_->currentData().toInt();
    const app::Framing framing = app::Framing::usual().at(static_cast<std::size_t>(std::max(0, framing_->currentIndex())));
    choice.data_bits = framing.data_bits;
    choice.parity = framing.parity;
    choice.stop_bits = framing.stop_bits;
    return choice;
}

}  // namespace pmts::gui
