#pragma once

#include "pmts/app/distortion_table_presenter.hpp"

#include <QPicture>
#include <QWidget>

class QCustomPlot;

namespace pmts::gui {

/// Curves over the pixel's distance from the centre (thesis, fig. 5.14 and 5.15). Measured ones have points and differ in shape
/// too, computed ones are lines. Hover tells the values, the context menu saves the plot.
class CurvePlot : public QWidget {
    Q_OBJECT
public:
    explicit CurvePlot(QWidget* parent = nullptr);

    void show(const std::vector<app::TablePlots::Curve>& curves, const QString& value_axis);
    using QWidget::show;
    [[nodiscard]] const std::vector<app::TablePlots::Curve>& curves() const { return curves_; }
    [[nodiscard]] QPicture picture(const QSize& size);

protected:
    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void draw();
    void styleAxes();
    void drawCurve(const app::TablePlots::Curve& curve, int index);
    void tellHovered(const QPoint& at);
    void save();

    QCustomPlot* plot_;
    std::vector<app::TablePlots::Curve> curves_;
    QString value_axis_;
};

}  // namespace pmts::gui
