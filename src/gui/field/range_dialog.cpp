#include "range_dialog.hpp"

#include "ui_range_dialog.h"

#include <QPushButton>

namespace pmts::gui {

using Field = app::RangePresenter::Field;

RangeDialog::RangeDialog(app::RangePresenter& ranges, const app::UnitFormat& units, QWidget* parent)
    : QDialog(parent), ranges_(ranges), ui_(std::make_unique<Ui::RangeDialog>()) {
    ui_->setupUi(this);
    for (const Field field : {Field::kAssumed, Field::kNear, Field::kFar}) {
        editOf(field)->setKind(QuantityEdit::Kind::kLength);
        editOf(field)->setUnits(units);
        editOf(field)->setText(ranges_.text(field));
    }
    ui_->problem->hide();
    connect(ui_->forget, &QPushButton::clicked, &ranges_, &app::RangePresenter::forgetShot);
    connect(ui_->buttons, &QDialogButtonBox::accepted, this,
            [this] { ranges_.setTexts(ui_->assumed->text(), ui_->near_end->text(), ui_->far_end->text()); });
    connect(&ranges_, &app::RangePresenter::accepted, this, &QDialog::accept);
    connect(&ranges_, &app::RangePresenter::rejected, this, &RangeDialog::showRejection);
    connect(&ranges_, &app::RangePresenter::changed, this, &RangeDialog::showInUse);
    showInUse();
    ui_->assumed->setFocus();
    ui_->assumed->selectAll();
}

RangeDialog::~RangeDialog() = default;

QuantityEdit* RangeDialog::editOf(Field field) const {
    switch (field) {
        case Field::kAssumed:
            return ui_->assumed;
        case Field::kNear:
            return ui_->near_end;
        case Field::kFar:
            break;
    }
    return ui_->far_end;
}

void RangeDialog::showInUse() {
    ui_->in_use->setText(ranges_.inUseText());
    ui_->forget->setEnabled(ranges_.hasShot());
}

void RangeDialog::showRejection(Field field, const core::Error& error) {
    for (const Field each : {Field::kAssumed, Field::kNear, Field::kFar}) {
        editOf(each)->setWrong(each == field ? error.sentence() : QString());
    }
    ui_->problem->setText(error.sentence());
    ui_->problem->show();
    editOf(field)->setFocus();
}

}  // namespace pmts::gui
