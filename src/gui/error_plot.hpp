#pragma once

#include "pmts/app/method_page.hpp"

#include <QColor>
#include <QPicture>
#include <QWidget>

class QCustomPlot;

namespace pmts::gui {

/// Colours of a plot: those of the palette on the screen, black on white on paper.
struct PlotLook {
    QColor ground, text, grid, ha, va;
    double line_px = 1.0;
};

[[nodiscard]] PlotLook screenLook();
[[nodiscard]] PlotLook paperLook();

/// The errors of a method as bars, one pair a target, or as arrows at the targets' places in the image. Hover tells the
/// values, the context menu saves the plot.
class ErrorPlot : public QWidget {
    Q_OBJECT
public:
    explicit ErrorPlot(QWidget* parent = nullptr);

    void showBars(const app::MethodPage& page, const QString& unit);
    void showVectors(const app::MethodPage& page, const QSize& image_px, const QString& unit);
    void setLook(const PlotLook& look);  ///< fixed from now on; otherwise the palette's
    /// The plot drawn at a size of its own, for paper and for files.
    [[nodiscard]] QPicture picture(const QSize& size);
    [[nodiscard]] const QCustomPlot& plot() const { return *plot_; }

protected:
    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void draw();
    void drawBars();
    void drawVectors();
    void drawArrow(const QPointF& from, const QPointF& to, const QString& label);
    void keepSquarePixels();
    void styleAxes();
    void tellHovered(const QPoint& at);
    void save();

    QCustomPlot* plot_;
    app::MethodPage page_;
    QString unit_;
    QSize image_px_;  ///< empty: bars
    PlotLook look_;
    bool follows_palette_ = true;
};

}  // namespace pmts::gui
