#pragma once

#include "lab_step.hpp"
#include "pmts/app/lab/self_calibration_presenter.hpp"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;
class QTabWidget;

namespace pmts::gui {

class CorrelationTable;
class ResidualPlot;

/// Laboratory step: pick a spot, press Calibrate, read the result, accept or reject.
class SelfCalibrationStep : public LabStep {
    Q_OBJECT
public:
    explicit SelfCalibrationStep(app::SelfCalibrationPresenter& calibration, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Self-calibration"); }
    bool pictureClicked(const QPointF& frame_px) override;
    void paintOver(QPainter& painter, const QTransform& widget_from_frame) override;

private:
    void buildChoices();
    void buildWait();
    void buildResult();
    void wire();
    void showAll();
    void showProgress();
    void showResult();

    app::SelfCalibrationPresenter& calibration_;
    QLabel* step_;
    QLabel* message_;
    QWidget* choices_;
    QCheckBox* measure_;
    QCheckBox* handle_;
    QCheckBox* sighted_;
    QPushButton* calibrate_;
    QPushButton* further_;
    QWidget* wait_;
    QProgressBar* bar_;
    QLabel* progress_;
    QPushButton* cancel_;
    QWidget* result_;
    QLabel* verdict_;
    QLabel* quality_;
    QTabWidget* tabs_;
    QTableWidget* table_;
    ResidualPlot* vectors_;
    ResidualPlot* radius_;
    CorrelationTable* correlation_;
    QPushButton* accept_;
    QPushButton* reject_;
    QPushButton* compare_;
};

}  // namespace pmts::gui
