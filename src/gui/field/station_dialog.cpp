#include "station_dialog.hpp"

#include "ui_station_dialog.h"

#include <QPushButton>

namespace pmts::gui {

using app::StationField;

StationDialog::StationDialog(app::StationPresenter& station, const app::InstrumentDesk& instrument,
                             app::Preferences& preferences, QWidget* parent)
    : QDialog(parent), station_(station), ui_(std::make_unique<Ui::StationDialog>()) {
    ui_->setupUi(this);
    fields_ = {{StationField::kName, ui_->name},
               {StationField::kEasting, ui_->easting},
               {StationField::kNorthing, ui_->northing},
               {StationField::kHeight, ui_->height},
               {StationField::kInstrumentHeight, ui_->instrument_height},
               {StationField::kOrientation, ui_->orientation},
               {StationField::kBearing, ui_->bearing},
               {StationField::kKnownEasting, ui_->known_easting},
               {StationField::kKnownNorthing, ui_->known_northing}};
    for (QuantityEdit* angle : {ui_->orientation, ui_->bearing}) {
        angle->setKind(QuantityEdit::Kind::kAngle);
    }
    connect(&preferences, &app::Preferences::unitsChanged, this, &StationDialog::showUnits);
    showUnits(preferences.units());
    wire(instrument);
}

StationDialog::~StationDialog() = default;

void StationDialog::wire(const app::InstrumentDesk& instrument) {
    connect(ui_->buttons->button(QDialogButtonBox::Apply), &QPushButton::clicked, this,
            &StationDialog::applyForm);
    connect(ui_->buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(ui_->set_bearing, &QPushButton::clicked, this,
            [this] { station_.orientByBearing(ui_->bearing->text()); });
    connect(ui_->set_known, &QPushButton::clicked, this, [this] {
        station_.orientToCoordinates(ui_->known_easting->text(), ui_->known_northing->text());
    });
    connect(&station_, &app::StationPresenter::stationChanged, this, &StationDialog::showForm);
    connect(&station_, &app::StationPresenter::fieldRejected, this, &StationDialog::showRejection);
    connect(&station_, &app::StationPresenter::applied, ui_->consequence, &QLabel::setText);
    connect(&instrument, &app::InstrumentDesk::pointingChanged, this,
            [this](const app::TimedPointing& reading) {
                ui_->now->setText(tr("Bearing now: %1").arg(station_.bearingText(reading.pointing.ha)));
            });
    showForm();
    showConsequence();
}

void StationDialog::showForm() {
    const app::StationForm form = station_.form();
    ui_->name->setText(form.name);
    ui_->easting->setText(form.easting);
    ui_->northing->setText(form.northing);
    ui_->height->setText(form.height);
    ui_->instrument_height->setText(form.instrument_height);
    ui_->orientation->setText(form.orientation);
}

void StationDialog::showConsequence() {
    const int here = station_.pointsObservedHere();
    ui_->consequence->setText(
        here > 0
            ? tr("A change recomputes the %n point(s) observed here; one undo takes it back.", nullptr, here)
            : QString());
}

void StationDialog::showUnits(const app::UnitFormat& units) {
    for (const auto& [field, edit] : fields_) {
        if (auto* const quantity = qobject_cast<QuantityEdit*>(edit)) {
            quantity->setUnits(units);
        }
    }
}

void StationDialog::applyForm() {
    for (const auto& [field, edit] : fields_) {
        if (auto* const quantity = qobject_cast<QuantityEdit*>(edit)) {
            quantity->setWrong({});
        }
    }
    station_.apply({.name = ui_->name->text(),
                    .easting = ui_->easting->text(),
                    .northing = ui_->northing->text(),
                    .height = ui_->height->text(),
                    .instrument_height = ui_->instrument_height->text(),
                    .orientation = ui_->orientation->text()});
}

void StationDialog::showRejection(StationField field, const core::Error& error) {
    QLineEdit* const edit = fields_.at(field);
    if (auto* const quantity = qobject_cast<QuantityEdit*>(edit)) {
        quantity->setWrong(error.sentence());
    }
    ui_->consequence->setText(error.sentence());
    edit->setFocus();
    edit->selectAll();
}

}  // namespace pmts::gui
