#include "aiming_dialog.hpp"

#include "ui_aiming_dialog.h"

#include <QPushButton>

namespace pmts::gui {

using app::AimingField;

AimingDialog::AimingDialog(app::AimingPresenter& aiming, app::Preferences& preferences, QWidget* parent)
    : QDialog(parent), aiming_(aiming), ui_(std::make_unique<Ui::AimingDialog>()) {
    ui_->setupUi(this);
    ui_->method->addItems(app::AimingPresenter::methodNames());
    fields_ = {{AimingField::kTolerancePx, ui_->tolerance_px}, {AimingField::kTolerance, ui_->tolerance},
               {AimingField::kHighest, ui_->highest},          {AimingField::kLowest, ui_->lowest},
               {AimingField::kSectorFrom, ui_->sector_from},   {AimingField::kSectorTo, ui_->sector_to},
               {AimingField::kLatitude, ui_->latitude},        {AimingField::kLongitude, ui_->longitude},
               {AimingField::kSunCone, ui_->sun_cone},         {AimingField::kTurns, ui_->turns}};
    for (const auto& [field, edit] : fields_) {
        if (auto* const quantity = qobject_cast<QuantityEdit*>(edit)) {
            quantity->setKind(QuantityEdit::Kind::kAngle);
        }
    }
    connect(&preferences, &app::Preferences::unitsChanged, this, &AimingDialog::showUnits);
    showUnits(preferences.units());
    wire();
    showForm();
}

AimingDialog::~AimingDialog() = default;

void AimingDialog::wire() {
    QPushButton* const apply = ui_->buttons->button(QDialogButtonBox::Apply);
    apply->setDefault(true);
    connect(apply, &QPushButton::clicked, this, &AimingDialog::applyForm);
    connect(ui_->buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(ui_->hangs_free, &QPushButton::clicked, &aiming_, &app::AimingPresenter::cableHangsFree);
    connect(ui_->method, &QComboBox::currentIndexChanged, this, &AimingDialog::showState);
    for (QCheckBox* box : {ui_->recentre, ui_->has_sector, ui_->avoids_sun, ui_->watches_cable}) {
        connect(box, &QCheckBox::toggled, this, &AimingDialog::showState);
    }
    connect(&aiming_, &app::AimingPresenter::changed, this, &AimingDialog::showState);
    connect(&aiming_, &app::AimingPresenter::fieldRejected, this, &AimingDialog::showRejection);
    connect(&aiming_, &app::AimingPresenter::applied, this, [this](const QString& sentence) {
        showForm();
        ui_->answer->setText(sentence);
    });
}

void AimingDialog::showForm() {
    const app::AimingForm form = aiming_.form();
    ui_->method->setCurrentIndex(form.method);
    ui_->recentre->setChecked(form.recentre);
    ui_->click_turns->setChecked(form.click_turns);
    ui_->face_two->setChecked(form.face_two_allowed);
    ui_->has_sector->setChecked(form.has_sector);
    ui_->avoids_sun->setChecked(form.avoids_sun);
    ui_->watches_cable->setChecked(form.watches_cable);
    const std::pair<QLineEdit*, QString> texts[] = {
        {ui_->tolerance_px, form.tolerance_px}, {ui_->tolerance, form.tolerance}, {ui_->highest, form.highest},
        {ui_->lowest, form.lowest},             {ui_->sector_from, form.sector_from}, {ui_->sector_to, form.sector_to},
        {ui_->latitude, form.latitude},         {ui_->longitude, form.longitude}, {ui_->sun_cone, form.sun_cone},
        {ui_->turns, form.turns}};
    for (const auto& [edit, text] : texts) {
        edit->setText(text);
    }
    showState();
}

/// What can be typed now, and how Sun and cable stand.
void AimingDialog::showState() {
    ui_->method_error->setText(tr("Known error: %1.").arg(app::AimingPresenter::methodError(ui_->method->currentIndex())));
    ui_->tolerance_px->setEnabled(ui_->recentre->isChecked());
    ui_->tolerance->setEnabled(ui_->recentre->isChecked());
    ui_->sector_from->setEnabled(ui_->has_sector->isChecked());
    ui_->sector_to->setEnabled(ui_->has_sector->isChecked());
    ui_->sun_cone->setEnabled(ui_->avoids_sun->isChecked());
    ui_->turns->setEnabled(ui_->watches_cable->isChecked());
    ui_->sun_text->setText(aiming_.sunText());
    ui_->cable_text->setText(aiming_.cableText());
}

void AimingDialog::showUnits(const app::UnitFormat& units) {
    for (const auto& [field, edit] : fields_) {
        if (auto* const quantity = qobject_cast<QuantityEdit*>(edit)) {
            quantity->setUnits(units);
        }
    }
}

void AimingDialog::applyForm() {
    for (const auto& [field, edit] : fields_) {
        if (auto* const quantity = qobject_cast<QuantityEdit*>(edit)) {
            quantity->setWrong({});
        }
    }
    aiming_.apply({.method = ui_->method->currentIndex(),
                   .recentre = ui_->recentre->isChecked(),
                   .click_turns = ui_->click_turns->isChecked(),
                   .tolerance_px = ui_->tolerance_px->text(),
                   .tolerance = ui_->tolerance->text(),
                   .highest = ui_->highest->text(),
                   .lowest = ui_->lowest->text(),
                   .face_two_allowed = ui_->face_two->isChecked(),
                   .has_sector = ui_->has_sector->isChecked(),
                   .sector_from = ui_->sector_from->text(),
                   .sector_to = ui_->sector_to->text(),
                   .avoids_sun = ui_->avoids_sun->isChecked(),
                   .latitude = ui_->latitude->text(),
                   .longitude = ui_->longitude->text(),
                   .sun_cone = ui_->sun_cone->text(),
                   .watches_cable = ui_->watches_cable->isChecked(),
                   .turns = ui_->turns->text()});
}

void AimingDialog::showRejection(AimingField field, const core::Error& error) {
    QLineEdit* const edit = fields_.at(field);
    if (auto* const quantity = qobject_cast<QuantityEdit*>(edit)) {
        quantity->setWrong(error.sentence());
    }
    ui_->answer->setText(error.sentence());
    edit->setFocus();
    edit->selectAll();
}

}  // namespace pmts::gui
