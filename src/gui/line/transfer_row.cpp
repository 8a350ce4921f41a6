#include "transfer_row.hpp"

#include "parts/lab_parts.hpp"

#include <QHBoxLayout>
#include <QProgressBar>

namespace pmts::gui {
namespace {

constexpr int kSteps = 1000;

}  // namespace

TransferRow::TransferRow(const char* object_name, QWidget* parent)
    : QWidget(parent),
      text_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(labButton(tr("&Cancel"), object_name, this)) {
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(text_, 1);
    row->addWidget(bar_, 1);
    row->addWidget(cancel_);
    bar_->setTextVisible(false);
    bar_->setAccessibleName(tr("How far it is"));
    connect(cancel_, &QPushButton::clicked, this, &TransferRow::cancelled);
    QSizePolicy keeps = sizePolicy();
    keeps.setRetainSizeWhenHidden(true);  // what is below must not jump under the finger
    setSizePolicy(keeps);
    hide();
}

void TransferRow::showTransfer(const app::TransferView& transfer) {
    text_->setText(transfer.text);
    bar_->setRange(0, transfer.fraction ? kSteps : 0);
    bar_->setValue(transfer.fraction ? static_cast<int>(*transfer.fraction * kSteps) : 0);
    setVisible(transfer.busy);
}

}  // namespace pmts::gui
