#pragma once

#include "plot_widget.hpp"
#include "pmts/app/field/method_page.hpp"

namespace pmts::gui {

/// The errors of a method as bars, one pair a target, or as arrows at the targets' places in the image.
class ErrorPlot : public PlotWidget {
    Q_OBJECT
public:
    explicit ErrorPlot(QWidget* parent = nullptr);

    void showBars(const app::MethodPage& page, const QString& unit);
    void showVectors(const app::MethodPage& page, const QSize& image_px, const QString& unit);
    /// `target,error_ha_<unit>,error_va_<unit>,column_px,row_px`, a line each.
    [[nodiscard]] QString csv() const override;

protected:
    void draw() override;
    [[nodiscard]] QString textAt(const QPoint& at) const override;

private:
    void drawBars();
    void drawVectors();
    void drawLabelled(const QPointF& from, const QPointF& to, const QString& label);

    app::MethodPage page_;
    QString unit_;
    QSize image_px_;  ///< empty: bars
};

}  // namespace pmts::gui
