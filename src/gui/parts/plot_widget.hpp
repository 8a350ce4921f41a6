#pragma once

#include "pmts/core/result.hpp"

#include <QColor>
#include <QPen>
#include <QPicture>
#include <QVector>
#include <QWidget>

#include <optional>

class QCPGraph;
class QCPScatterStyle;
class QCustomPlot;
class QLabel;

namespace pmts::gui {

/// Colours of a plot: those of the palette on the screen, black on white on paper.
struct PlotLook {
    QColor ground, text, grid, ha, va;
    double line_px = 1.0;
};

[[nodiscard]] PlotLook screenLook();
[[nodiscard]] PlotLook paperLook();
/// 1, 2 or 5 times a power of ten, not above the value; value > 0.
[[nodiscard]] double roundBelow(double value);
/// A text as one cell of a CSV line, in quotes.
[[nodiscard]] QString csvCell(QString text);

/// A plot in the colours of the palette. Hover tells the values; the context menu saves the picture (black on white) and the
/// values, and a line below the plot says what came of it. Subclasses draw into canvas() and know their values.
class PlotWidget : public QWidget {
    Q_OBJECT
public:
    /// `file_name`: what a saved file is called at first, without its ending.
    PlotWidget(QString file_name, QWidget* parent);

    void setNotice(const QString& why_empty);  ///< stands in an empty plot
    [[nodiscard]] bool isEmpty() const { return is_empty_; }
    void setLook(const PlotLook& look);  ///< fixed from now on; otherwise the palette's
    /// The plot drawn at a size of its own, for paper and for files.
    [[nodiscard]] QPicture picture(const QSize& size);
    [[nodiscard]] virtual QString csv() const = 0;  ///< the values under a header line
    /// Writes what the ending asks for: .svg, .csv, else a PNG. kFile when it cannot be written.
    [[nodiscard]] core::Result<void> write(const QString& path);
    void save(const QString& path);  ///< the same; the line below says what came of it
    [[nodiscard]] const QCustomPlot& plot() const { return *plot_; }

protected:
    virtual void draw() = 0;  ///< into an empty plot with styled axes
    [[nodiscard]] virtual QString textAt(const QPoint& at) const;  ///< what hover tells; empty: nothing
    void redraw();

    [[nodiscard]] QCustomPlot& canvas() { return *plot_; }
    [[nodiscard]] const PlotLook& look() const { return look_; }
    void addArrow(const QPointF& from, const QPointF& to, const QPen& pen);
    QCPGraph* addDots(const QVector<double>& x, const QVector<double>& y, const QCPScatterStyle& style);
    /// The picture's outline under axes of columns and rows, as wide per pixel as high.
    void drawFrame(const QSize& frame_px, const QString& columns);
    void drawNotice();  ///< instead of the axes

    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    void styleAxes();
    void styleLegend();
    void keepSquarePixels();
    void fitFrame();
    void ask(const QString& heading, const QString& filters);
    [[nodiscard]] QByteArray drawing();
    [[nodiscard]] QByteArray bitmap();

    QCustomPlot* plot_;
    QLabel* said_;
    QString file_name_, notice_;
    PlotLook look_;
    bool follows_palette_ = true;
    bool is_empty_ = false;
    std::optional<QSize> square_px_;  ///< the frame whose pixels are square in the plot
};

}  // namespace pmts::gui
