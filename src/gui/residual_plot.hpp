#pragma once

#include "error_plot.hpp"
#include "pmts/app/self_calibration_view.hpp"

namespace pmts::gui {

/// Residuals of a calibration: as arrows over the frame, magnified by a number that is shown, or their
/// lengths against the radius. Pictures left out are crosses. The context menu saves the plot or its numbers.
class ResidualPlot : public QWidget {
    Q_OBJECT
public:
    enum class Kind { kVectors, kRadius };
    explicit ResidualPlot(Kind kind, QWidget* parent = nullptr);

    void showView(const app::SelfCalibrationView& view);
    /// `column,row,residual x,residual y,spot,left out`, a line each.
    [[nodiscard]] QString csv() const;
    [[nodiscard]] const QCustomPlot& plot() const { return *plot_; }

protected:
    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void draw();
    void styleAxes(const PlotLook& look);
    void drawVectors(const PlotLook& look);
    void drawRadius(const PlotLook& look);
    void drawArrow(const QPointF& from, const QPointF& to, const PlotLook& look, bool outlier);
    void keepSquarePixels();
    void save();

    Kind kind_;
    QCustomPlot* plot_;
    app::SelfCalibrationView view_;
};

}  // namespace pmts::gui
