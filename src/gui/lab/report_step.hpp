#pragma once

#include "calibration_plots.hpp"
#include "lab_step.hpp"
#include "pmts/app/lab/profiles_presenter.hpp"

class QLabel;

namespace pmts::gui {

/// The report of the calibration in use: texts, plots, PDF.
class ReportStep : public LabStep {
    Q_OBJECT
public:
    ReportStep(app::ProfilesPresenter& profiles, const app::Preferences& preferences, QWidget* parent = nullptr);
    [[nodiscard]] QString title() const override { return tr("Report"); }
    void entered() override { showAll(); }

private:
    void showAll();
    void savePdf();

    app::ProfilesPresenter& profiles_;
    const app::Preferences& preferences_;
    QLabel *texts_, *said_;
    CalibrationPlots plots_;
};

}  // namespace pmts::gui
