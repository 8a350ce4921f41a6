#pragma once

#include "error_plot.hpp"
#include "pmts/app/calibration_report.hpp"

#include <QPainter>
#include <QWidget>

namespace pmts::gui {

enum class CalibrationFigure {
    kResiduals,     ///< vectors over the picture, enlarged
    kRadial,        ///< length of the residuals over the distance from the principal point
    kAngleCurve,    ///< thesis fig. 5.14: angle off the axis against pixel, with the ideal line
    kWidthCurve,    ///< thesis fig. 5.15: angle of a pixel
};

[[nodiscard]] QString figureTitle(CalibrationFigure figure);
/// Draws a figure into a rectangle, on the screen and on paper alike.
void paintFigure(QPainter& painter, const QRectF& place, const app::CalibrationReport& report, CalibrationFigure figure,
                 const PlotLook& look);
/// The figure's numbers as CSV with a header line.
[[nodiscard]] QString figureCsv(const app::CalibrationReport& report, CalibrationFigure figure);

/// A figure as a widget; the context menu saves it as PNG, SVG or CSV.
class CalibrationPlot : public QWidget {
    Q_OBJECT
public:
    explicit CalibrationPlot(CalibrationFigure figure, QWidget* parent = nullptr);
    void show(const app::CalibrationReport& report);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void save();

    CalibrationFigure figure_;
    app::CalibrationReport report_;
};

}  // namespace pmts::gui
