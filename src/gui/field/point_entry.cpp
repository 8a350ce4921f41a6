#include "point_entry.hpp"

#include "ui_point_entry.h"

#include <QPushButton>

namespace pmts::gui {
namespace {

constexpr int kCodeColumns = 4;
constexpr int kCodeHeight_px = 44;

}  // namespace

PointEntry::PointEntry(app::RecordingPresenter& recording, app::Preferences& preferences, QWidget* parent)
    : QWidget(parent), recording_(recording), ui_(std::make_unique<Ui::PointEntry>()) {
    ui_->setupUi(this);
    ui_->mode->addItems(app::RecordingPresenter::modeNames());
    for (int column = 0; column < kCodeColumns; ++column) {
        ui_->code_grid->setColumnStretch(column, 1);
    }
    ui_->target_height->setKind(QuantityEdit::Kind::kLength);
    ui_->target_height->setUnits(preferences.units());
    connect(&preferences, &app::Preferences::unitsChanged, this, [this](const app::UnitFormat& units) {
        ui_->target_height->setUnits(units);
        showNextPoint();
    });
    wireFields();
    showNextPoint();
    showCodes();
}

PointEntry::~PointEntry() = default;

void PointEntry::wireFields() {
    passOn(ui_->id, &app::RecordingPresenter::setPointId);
    passOn(ui_->code, &app::RecordingPresenter::setCode);
    passOn(ui_->remark, &app::RecordingPresenter::setRemark);
    connect(ui_->target_height, &QuantityEdit::understood, &recording_,
            &app::RecordingPresenter::setTargetHeightText);
    connect(ui_->mode, &QComboBox::activated, this,
            [this](int index) { recording_.setMode(static_cast<decltype(recording_.mode())>(index)); });
    for (QLineEdit* field : {ui_->id, ui_->code, ui_->remark, static_cast<QLineEdit*>(ui_->target_height)}) {
        connect(field, &QLineEdit::returnPressed, this, &PointEntry::typingEnded);
    }
    connect(&recording_, &app::RecordingPresenter::nextPointChanged, this, &PointEntry::showNextPoint);
    connect(&recording_, &app::RecordingPresenter::modeChanged, this, &PointEntry::showNextPoint);
    connect(&recording_, &app::RecordingPresenter::codesChanged, this, &PointEntry::showCodes);
    connect(&recording_, &app::RecordingPresenter::targetHeightRejected, this,
            &PointEntry::showHeightProblem);
}

void PointEntry::passOn(QLineEdit* field, void (app::RecordingPresenter::*setter)(const QString&)) {
    connect(field, &QLineEdit::textEdited, this, [this, field, setter](const QString& text) {
        typed_in_ = field;
        (recording_.*setter)(text);
        typed_in_ = nullptr;
    });
    connect(field, &QLineEdit::editingFinished, this, &PointEntry::showNextPoint);
}

/// Leaves the text of somebody who is typing alone: the presenter trims it.
void PointEntry::showText(QLineEdit* field, const QString& text) {
    if (field != typed_in_ && field->text() != text) {
        field->setText(text);
    }
}

void PointEntry::startTyping() {
    ui_->id->setFocus(Qt::ShortcutFocusReason);
    ui_->id->selectAll();
}

void PointEntry::showNextPoint() {
    showText(ui_->id, recording_.pointId());
    showText(ui_->code, recording_.code());
    showText(ui_->remark, recording_.remark());
    if (!ui_->target_height->hasFocus()) {
        ui_->target_height->setWrong({});
        showText(ui_->target_height, recording_.targetHeightText());
    }
    ui_->mode->setCurrentIndex(static_cast<int>(recording_.mode()));
    const auto buttons = ui_->codes->findChildren<QPushButton*>();
    for (QPushButton* button : buttons) {
        button->setChecked(button->text() == recording_.code());
    }
}

void PointEntry::showCodes() {
    qDeleteAll(ui_->codes->findChildren<QPushButton*>());
    int index = 0;
    for (const QString& code : recording_.codeButtons()) {
        auto* const button = new QPushButton(code, ui_->codes);
        button->setCheckable(true);
        button->setMinimumHeight(kCodeHeight_px);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAccessibleName(tr("Code %1").arg(code));
        connect(button, &QPushButton::clicked, this, [this, code] {
            recording_.setCode(code);
            showNextPoint();
        });
        ui_->code_grid->addWidget(button, index / kCodeColumns, index % kCodeColumns);
        ++index;
    }
    ui_->codes->setVisible(index > 0);
    showNextPoint();
}

void PointEntry::showHeightProblem(const core::Error& error) {
    ui_->target_height->setWrong(error.sentence());
}

}  // namespace pmts::gui
