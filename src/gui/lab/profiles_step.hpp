#pragma once

#include "lab_step.hpp"
#include "pmts/app/lab/profiles_presenter.hpp"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace pmts::gui {

/// The rig profiles: which is in use and what speaks against it, rename, copy, delete, import and export.
class ProfilesStep : public LabStep {
    Q_OBJECT
public:
    explicit ProfilesStep(app::ProfilesPresenter& profiles, QWidget* parent = nullptr);
    [[nodiscard]] QString title() const override { return tr("Profiles"); }

private:
    void showAll();
    [[nodiscard]] QString chosen() const;
    void rename();
    void remove();
    void editLimits();
    void exportChosen();
    void import();

    app::ProfilesPresenter& profiles_;
    QLabel* in_use_;
    QLabel* concerns_;
    QTableWidget* table_;
    QLabel* details_;
    QCheckBox* picks_;
    QDoubleSpinBox* temperature_;
    QPushButton *use_, *back_, *rename_, *remove_;
};

}  // namespace pmts::gui
