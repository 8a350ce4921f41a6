#pragma once

#include "pmts/app/field/aiming_presenter.hpp"

#include <QDialog>

#include <map>
#include <memory>

class QLineEdit;

namespace Ui {
class AimingDialog;
}

namespace pmts::gui {

/// Method, re-centring and the guards. Stays open while the telescope moves.
class AimingDialog : public QDialog {
    Q_OBJECT
public:
    AimingDialog(app::AimingPresenter& aiming, app::Preferences& preferences, QWidget* parent = nullptr);
    ~AimingDialog() override;

private:
    void wire();
    void showForm();
    void showState();
    void showUnits(const app::UnitFormat& units);
    void applyForm();
    void showRejection(app::AimingField field, const core::Error& error);

    app::AimingPresenter& aiming_;
    std::unique_ptr<Ui::AimingDialog> ui_;
    std::map<app::AimingField, QLineEdit*> fields_;
};

}  // namespace pmts::gui
