#pragma once

#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/field/station_presenter.hpp"

#include <QDialog>

#include <map>
#include <memory>

class QLineEdit;

namespace Ui {
class StationDialog;
}

namespace pmts::gui {

/// Station coordinates, instrument height and orientation. Stays open while the telescope is pointed.
class StationDialog : public QDialog {
    Q_OBJECT
public:
    StationDialog(app::StationPresenter& station, const app::InstrumentDesk& instrument,
                  app::Preferences& preferences, QWidget* parent = nullptr);
    ~StationDialog() override;

private:
    void wire(const app::InstrumentDesk& instrument);
    void showForm();
    void showConsequence();
    void showUnits(const app::UnitFormat& units);
    void applyForm();
    void showRejection(app::StationField field, const core::Error& error);

    app::StationPresenter& station_;
    std::unique_ptr<Ui::StationDialog> ui_;
    std::map<app::StationField, QLineEdit*> fields_;
};

}  // namespace pmts::gui
