#include "two_face_panel.hpp"

#include "parts/lab_parts.hpp"
#include "parts/state_lamp.hpp"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>

namespace pmts::gui {

TwoFacePanel::TwoFacePanel(app::TwoFacePresenter& faces, QWidget* parent)
    : QWidget(parent),
      faces_(faces),
      lamp_(new StateLamp(this)),
      instruction_(labText("two_face_instruction", this)),
      outcome_(labText("two_face_outcome", this)),
      id_(new QLineEdit(this)),
      code_(new QLineEdit(this)),
      measure_(labButton(tr("Meas&ure"), "two_face_measure", this)),
      record_(labButton(tr("&Record the mean"), "two_face_record", this)),
      discard_(labButton(tr("&Discard"), "two_face_discard", this)),
      cancel_(labButton(tr("Ca&ncel"), "two_face_cancel", this)) {
    auto* const column = new QVBoxLayout(this);
    QFont bold = instruction_->font();
    bold.setBold(true);
    instruction_->setFont(bold);
    auto* const steps = new QHBoxLayout;
    steps->addWidget(measure_);
    steps->addWidget(cancel_);
    auto* const outcome_row = new QHBoxLayout;
    outcome_row->addWidget(lamp_, 0, Qt::AlignTop);
    outcome_row->addWidget(outcome_, 1);
    auto* const form = new QFormLayout;
    id_->setObjectName(QStringLiteral("two_face_id"));
    code_->setObjectName(QStringLiteral("two_face_code"));
    for (QLineEdit* const edit : {id_, code_}) {
        edit->setMinimumHeight(ActionButton::kLeastSide_px);
    }
    form->addRow(tr("Point"), id_);
    form->addRow(tr("Code"), code_);
    auto* const ends = new QHBoxLayout;
    ends->addWidget(record_);
    ends->addWidget(discard_);
    column->addWidget(instruction_);
    column->addLayout(steps);
    column->addLayout(outcome_row);
    column->addLayout(form);
    column->addLayout(ends);
    column->addStretch(1);
    connect(measure_, &QPushButton::clicked, &faces_, &app::TwoFacePresenter::measure);
    connect(cancel_, &QPushButton::clicked, &faces_, &app::TwoFacePresenter::cancel);
    connect(discard_, &QPushButton::clicked, &faces_, &app::TwoFacePresenter::discard);
    connect(record_, &QPushButton::clicked, &faces_, [this] { faces_.record(id_->text(), code_->text()); });
    connect(id_, &QLineEdit::textChanged, this, &TwoFacePanel::showAll);
    connect(&faces_, &app::TwoFacePresenter::changed, this, &TwoFacePanel::showAll);
    connect(&faces_, &app::TwoFacePresenter::recorded, id_, &QLineEdit::clear);
    showAll();
}

/// What nobody typed gives way when the ID gets used.
void TwoFacePanel::propose(bool done) {
    const bool untouched = id_->text().isEmpty() ? !id_->hasFocus() : id_->text() == proposed_;
    if (done && untouched) {
        proposed_ = faces_.proposedId();
        id_->setText(proposed_);
    }
}

void TwoFacePanel::showAll() {
    const app::StatusItem outcome = faces_.outcome();
    const bool done = faces_.step() == app::TwoFaceStep::kDone;
    propose(done);
    instruction_->setText(faces_.instruction());
    lamp_->setState(faces_.isBusy() ? app::DeviceState::kBusy : outcome.state);
    outcome_->setText(outcome.details.isEmpty() ? outcome.text : outcome.text + u'\n' + outcome.details);
    measure_->setEnabled(!faces_.isBusy());
    cancel_->setEnabled(faces_.canCancel());
    record_->setEnabled(done && !id_->text().trimmed().isEmpty());
    discard_->setEnabled(!faces_.isBusy() && faces_.step() != app::TwoFaceStep::kFirst);
}

}  // namespace pmts::gui
