#pragma once

#include "lab_panel.hpp"
#include "pmts/app/lab/distortion_table_presenter.hpp"

#include <QToolButton>

#include <array>

class QComboBox;
class QDoubleSpinBox;
class QProgressBar;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace pmts::gui {

class CurvePlot;

/// The distortion table: the grid over the live view, the sweep, the rows, the plots.
class TableStep : public LabPanel {
    Q_OBJECT
public:
    explicit TableStep(app::DistortionTablePresenter& table, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override { return tr("Table"); }
    void entered() override { showAll(); }
    bool pictureClicked(const QPointF& frame_px) override;
    void paintOver(QPainter& painter, const QTransform& widget_from_frame) override;

private:
    void buildGrid(QVBoxLayout& column);
    void buildRun(QVBoxLayout& column);
    void buildResult();
    [[nodiscard]] QWidget* measurePage();
    [[nodiscard]] QWidget* rowsPage();
    void takeDirections();
    void showAll();
    void showProgress();
    void showRows();

    app::DistortionTablePresenter& table_;
    QDoubleSpinBox* spacing_;
    std::array<QToolButton*, calibration::kRadiusDirections> directions_{};
    QPushButton *automatic_, *by_hand_, *start_, *cancel_, *other_target_, *accept_;
    QPushButton *add_row_, *remove_row_, *forget_, *import_, *export_, *remove_run_;
    QComboBox* runs_;
    QLabel *target_, *missed_, *trouble_, *summary_;
    QProgressBar* progress_;
    QTableWidget* rows_;
    CurvePlot *angles_, *widths_;
};

}  // namespace pmts::gui
