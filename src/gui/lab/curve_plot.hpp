#pragma once

#include "parts/plot_widget.hpp"
#include "pmts/app/lab/distortion_table_presenter.hpp"

namespace pmts::gui {

/// Curves over the pixel's distance from the centre (thesis, fig. 5.14 and 5.15). Measured ones have points and differ in shape
/// too, computed ones are lines.
class CurvePlot : public PlotWidget {
    Q_OBJECT
public:
    using Curve = app::TablePlots::Curve;

    explicit CurvePlot(QWidget* parent = nullptr);

    void showCurves(const std::vector<Curve>& curves, const QString& value_axis);
    [[nodiscard]] const std::vector<Curve>& curves() const { return curves_; }
    /// `curve,radius_px,value_gon`, a line each.
    [[nodiscard]] QString csv() const override;

protected:
    void draw() override;
    [[nodiscard]] QString textAt(const QPoint& at) const override;

private:
    void styleLegend();
    void drawCurve(const Curve& curve, std::size_t turn);

    std::vector<Curve> curves_;
    QString value_axis_;
};

}  // namespace pmts::gui
