#include "residual_plot.hpp"

#include <QContextMenuEvent>
#include <QFile>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMenu>
#include <QSvgGenerator>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kArrowShare = 0.09;  ///< of the frame's width: a long arrow
constexpr double kMargin = 0.05;

/// 1, 2 or 5 times a power of ten, not above the value.
double roundBelow(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double lead = value / power;
    return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

double length(const app::PlottedResidual& residual) {
    return std::hypot(residual.residual_px.x(), residual.residual_px.y());
}

/// What nine in ten used residuals stay below: one stray arrow does not shrink the others.
double usualLongest(const app::SelfCalibrationView& view) {
    std::vector<double> lengths;
    for (const app::PlottedResidual& residual : view.residuals) {
        if (!residual.outlier) {
            lengths.push_back(length(residual));
        }
    }
    if (lengths.empty()) {
        return 0.0;
    }
    std::ranges::sort(lengths);
    return lengths[lengths.size() * 9 / 10];
}

}  // namespace

ResidualPlot::ResidualPlot(Kind kind, QWidget* parent)
    : QWidget(parent), kind_(kind), plot_(new QCustomPlot(this)) {
    auto* const fill = new QHBoxLayout(this);
    fill->setContentsMargins(0, 0, 0, 0);
    fill->addWidget(plot_);
    plot_->setContextMenuPolicy(Qt::NoContextMenu);  // this widget's own
    setMinimumHeight(240);
}

void ResidualPlot::showView(const app::SelfCalibrationView& view) {
    view_ = view;
    draw();
}

void ResidualPlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange ||
        event->type() == QEvent::FontChange) {
        draw();
    }
}

void ResidualPlot::resizeEvent(QResizeEvent*) {
    if (kind_ == Kind::kVectors) {
        keepSquarePixels();
    }
}

void ResidualPlot::draw() {
    plot_->clearPlottables();
    plot_->clearItems();
    const PlotLook look = screenLook();
    styleAxes(look);
    if (!view_.residuals.empty()) {
        kind_ == Kind::kVectors ? drawVectors(look) : drawRadius(look);
    }
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ResidualPlot::styleAxes(const PlotLook& look) {
    plot_->setBackground(look.ground);
    for (QCPAxis* const axis : {plot_->xAxis, plot_->yAxis}) {
        axis->setBasePen(QPen(look.text, look.line_px));
        axis->setTickPen(QPen(look.text, look.line_px));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(look.text);
        axis->setLabelColor(look.text);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->ticker()->setTickCount(4);
        axis->grid()->setPen(QPen(look.grid, 1, Qt::DotLine));
        axis->grid()->setZeroLinePen(QPen(look.grid, 1, Qt::DotLine));
    }
}

void ResidualPlot::drawArrow(const QPointF& from, const QPointF& to, const PlotLook& look, bool outlier) {
    auto* const arrow = new QCPItemLine(plot_);
    arrow->start->setCoords(from);
    arrow->end->setCoords(to);
    arrow->setPen(
        QPen(outlier ? look.text : look.ha, 1.5 * look.line_px, outlier ? Qt::DotLine : Qt::SolidLine));
    arrow->setHead(QCPLineEnding(QCPLineEnding::esSpikeArrow, 5, 7));
}

void ResidualPlot::drawVectors(const PlotLook& look) {
    auto* const frame = new QCPItemRect(plot_);
    frame->topLeft->setCoords(-0.5, -0.5);
    frame->bottomRight->setCoords(view_.frame_px.width() - 0.5, view_.frame_px.height() - 0.5);
    frame->setPen(QPen(look.text, look.line_px));
    const double usual = usualLongest(view_);
    const double magnified = usual > 0 ? roundBelow(kArrowShare * view_.frame_px.width() / usual) : 1.0;
    const double most =
        2.5 * kArrowShare * view_.frame_px.width();  // an outlier's arrow ends inside the plot
    QVector<double> columns, rows, left_columns, left_rows;
    for (const app::PlottedResidual& residual : view_.residuals) {
        (residual.outlier ? left_columns : columns).append(residual.px.x());
        (residual.outlier ? left_rows : rows).append(residual.px.y());
        const double shown = std::min(magnified, most / std::max(1e-9, length(residual)));
        drawArrow(residual.px, residual.px + residual.residual_px * shown, look, residual.outlier);
    }
    const auto dots = [&](const QVector<double>& u, const QVector<double>& v,
                          QCPScatterStyle::ScatterShape shape) {
        QCPGraph* const graph = plot_->addGraph();
        graph->setData(u, v);
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(QCPScatterStyle(shape, QPen(look.text, look.line_px), look.ground, 5));
    };
    dots(columns, rows, QCPScatterStyle::ssCircle);
    dots(left_columns, left_rows, QCPScatterStyle::ssCross);
    plot_->xAxis->setLabel(tr("Column [px]; arrows %1 times as long").arg(magnified));
    plot_->yAxis->setLabel(tr("Row [px]"));
    plot_->yAxis->setRangeReversed(true);
    keepSquarePixels();
}

void ResidualPlot::drawRadius(const PlotLook& look) {
    QVector<double> radii, lengths, left_radii, left_lengths;
    for (const app::PlottedResidual& residual : view_.residuals) {
        const QPointF from_centre = residual.px - view_.centre_px;
        (residual.outlier ? left_radii : radii).append(std::hypot(from_centre.x(), from_centre.y()));
        (residual.outlier ? left_lengths : lengths).append(length(residual));
    }
    const double top = std::max(1e-6, 1.25 * *std::ranges::max_element(lengths));
    std::ranges::transform(left_lengths, left_lengths.begin(),
                           [top](double value) { return std::min(value, top); });
    const auto dots = [&](const QVector<double>& x, const QVector<double>& y, const QCPScatterStyle& style) {
        QCPGraph* const graph = plot_->addGraph();
        graph->setData(x, y);
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(style);
    };
    dots(radii, lengths, QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(look.ha, look.line_px), look.ha, 6));
    dots(left_radii, left_lengths,
         QCPScatterStyle(QCPScatterStyle::ssCross, QPen(look.text, 2 * look.line_px), Qt::NoBrush, 8));
    plot_->xAxis->setLabel(tr("Radius from the centre [px]"));
    plot_->yAxis->setLabel(tr("Residual [px]"));
    plot_->xAxis->setRange(0, std::hypot(view_.frame_px.width(), view_.frame_px.height()) / 2);
    plot_->yAxis->setRange(0, top * 1.02);
}

/// The whole frame with a margin, as wide per pixel as high.
void ResidualPlot::keepSquarePixels() {
    const double margin = kMargin * view_.frame_px.width();
    plot_->xAxis->setRange(-margin, view_.frame_px.width() + margin);
    plot_->yAxis->setRange(-margin, view_.frame_px.height() + margin);
    const QSize room = plot_->axisRect()->size();
    if (room.isEmpty() || view_.frame_px.isEmpty()) {
        return;
    }
    if (plot_->xAxis->range().size() / room.width() > plot_->yAxis->range().size() / room.height()) {
        plot_->yAxis->setScaleRatio(plot_->xAxis, 1.0);
    } else {
        plot_->xAxis->setScaleRatio(plot_->yAxis, 1.0);
    }
}

QString ResidualPlot::csv() const {
    QString text = QStringLiteral("column_px,row_px,residual_x_px,residual_y_px,spot,left_out\n");
    for (const app::PlottedResidual& residual : view_.residuals) {
        text += QStringLiteral("%1,%2,%3,%4,%5,%6\n")
                    .arg(residual.px.x(), 0, 'f', 4)
                    .arg(residual.px.y(), 0, 'f', 4)
                    .arg(residual.residual_px.x(), 0, 'f', 5)
                    .arg(residual.residual_px.y(), 0, 'f', 5)
                    .arg(residual.spot + 1)
                    .arg(residual.outlier ? 1 : 0);
    }
    return text;
}

void ResidualPlot::contextMenuEvent(QContextMenuEvent* event) {
    auto* const menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Save this plot or its numbers…"), this, &ResidualPlot::save);
    menu->popup(event->globalPos());
}

void ResidualPlot::save() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save this plot"), {},
                                                      tr("Picture or table (*.svg *.png *.csv)"));
    if (path.endsWith(QStringLiteral(".csv"))) {
        QFile file(path);
        if (file.open(QIODevice::WriteOnly | QIODevice::Text)) {
            file.write(csv().toUtf8());
        }
    } else if (path.endsWith(QStringLiteral(".svg"))) {
        QSvgGenerator file;
        file.setFileName(path);
        file.setSize(size());
        file.setViewBox(rect());
        QCPPainter painter(&file);
        plot_->toPainter(&painter, width(), height());
    } else if (!path.isEmpty()) {
        plot_->savePng(path.endsWith(QStringLiteral(".png")) ? path : path + QStringLiteral(".png"), 0, 0,
                       2.0);
    }
}

}  // namespace pmts::gui
