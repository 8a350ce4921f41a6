#include "curve_plot.hpp"

#include "error_plot.hpp"
#include "pmts/gui/theme.hpp"

#include <QContextMenuEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMenu>
#include <QSaveFile>
#include <QSvgGenerator>
#include <QToolTip>
#include <qcustomplot.h>

#include <array>
#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kReach_px = 14.0;
constexpr double kPoint_px = 6.0;
constexpr QSize kSaved_px(1000, 700);
constexpr std::array kShapes{QCPScatterStyle::ssCircle, QCPScatterStyle::ssSquare, QCPScatterStyle::ssTriangle,
                             QCPScatterStyle::ssDiamond, QCPScatterStyle::ssCross, QCPScatterStyle::ssPlus};
constexpr std::array kLines{Qt::SolidLine, Qt::DashLine, Qt::DotLine};

QByteArray csvOf(const std::vector<app::TablePlots::Curve>& curves) {
    QByteArray csv = "curve,radius_px,value_gon\n";
    for (const auto& curve : curves) {
        for (std::size_t i = 0; i < curve.radius_px.size(); ++i) {
            csv += '"' + curve.name.toUtf8() + "\"," + QByteArray::number(curve.radius_px[i], 'f', 3) + ',' +
                   QByteArray::number(curve.value_gon[i], 'f', 6) + '\n';
        }
    }
    return csv;
}

}  // namespace

CurvePlot::CurvePlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
    auto* const fill = new QHBoxLayout(this);
    fill->setContentsMargins(0, 0, 0, 0);
    fill->addWidget(plot_);
    plot_->setContextMenuPolicy(Qt::NoContextMenu);  // this widget's own
    connect(plot_, &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) { tellHovered(event->pos()); });
}

void CurvePlot::show(const std::vector<app::TablePlots::Curve>& curves, const QString& value_axis) {
    curves_ = curves;
    value_axis_ = value_axis;
    draw();
}

void CurvePlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        draw();
    }
}

void CurvePlot::draw() {
    plot_->clearGraphs();
    styleAxes();
    int measured = 0, computed = 0;
    for (const auto& curve : curves_) {
        drawCurve(curve, curve.measured ? measured++ : computed++);
    }
    plot_->xAxis->setLabel(tr("pixels from the centre"));
    plot_->yAxis->setLabel(value_axis_);
    plot_->rescaleAxes();
    plot_->yAxis->scaleRange(1.08);
    plot_->legend->setVisible(!curves_.empty());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void CurvePlot::styleAxes() {
    const PlotLook look = screenLook();
    plot_->setBackground(look.ground);
    for (QCPAxis* const axis : {plot_->xAxis, plot_->yAxis}) {
        axis->setBasePen(QPen(look.text, look.line_px));
        axis->setTickPen(QPen(look.text, look.line_px));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(look.text);
        axis->setLabelColor(look.text);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->grid()->setPen(QPen(look.grid, 1, Qt::DotLine));
        axis->grid()->setZeroLinePen(QPen(look.grid, 1, Qt::DotLine));
    }
    QFont small = font();
    small.setPointSizeF(0.85 * small.pointSizeF());
    plot_->legend->setBrush(look.ground);
    plot_->legend->setTextColor(look.text);
    plot_->legend->setBorderPen(QPen(look.grid, look.line_px));
    plot_->legend->setFont(small);
    plot_->legend->setRowSpacing(-4);
    const bool falls = !curves_.empty() && !curves_[0].value_gon.empty() && curves_[0].value_gon.back() < curves_[0].value_gon.front();
    plot_->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignBottom | (falls ? Qt::AlignLeft : Qt::AlignRight));
}

void CurvePlot::drawCurve(const app::TablePlots::Curve& curve, int index) {
    const PlotLook look = screenLook();
    QCPGraph* const graph = plot_->addGraph();
    graph->setName(curve.name);
    graph->setData(QVector<double>(curve.radius_px.begin(), curve.radius_px.end()),
                   QVector<double>(curve.value_gon.begin(), curve.value_gon.end()), true);
    const auto turn = static_cast<std::size_t>(index);
    if (curve.measured) {
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(QCPScatterStyle(kShapes[turn % kShapes.size()], QPen(look.ha, 1.5 * look.line_px), Qt::NoBrush, kPoint_px));
    } else {
        graph->setPen(QPen(index == 0 ? look.ha : look.va, 1.5 * look.line_px, kLines[turn % kLines.size()]));
    }
}

void CurvePlot::tellHovered(const QPoint& at) {
    for (int i = 0; i < plot_->graphCount(); ++i) {
        const QCPGraph* const graph = plot_->graph(i);
        for (const QCPGraphData& datum : *graph->data()) {
            const QPointF place(plot_->xAxis->coordToPixel(datum.key), plot_->yAxis->coordToPixel(datum.value));
            if (std::hypot(place.x() - at.x(), place.y() - at.y()) < kReach_px) {
                QToolTip::showText(plot_->mapToGlobal(at),
                                   tr("%1: %2 px, %3 gon").arg(graph->name()).arg(datum.key, 0, 'f', 1).arg(datum.value, 0, 'f', 5), plot_);
                return;
            }
        }
    }
    QToolTip::hideText();
}

QPicture CurvePlot::picture(const QSize& size) {
    QPicture drawn;
    QCPPainter painter;
    painter.begin(&drawn);
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    plot_->toPainter(&painter, size.width(), size.height());
    painter.end();
    return drawn;
}

void CurvePlot::contextMenuEvent(QContextMenuEvent* event) {
    auto* const menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Save this plot…"), this, &CurvePlot::save);
    menu->popup(event->globalPos());
}

void CurvePlot::save() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save this plot"), QStringLiteral("distortion.png"),
                                                      tr("Picture (*.png);;Drawing (*.svg);;Numbers (*.csv)"));
    if (path.endsWith(QLatin1String(".csv"))) {
        QSaveFile file(path);
        if (file.open(QIODevice::WriteOnly)) {
            file.write(csvOf(curves_));
            file.commit();
        }
    } else if (path.endsWith(QLatin1String(".svg"))) {
        QSvgGenerator svg;
        svg.setFileName(path);
        svg.setSize(kSaved_px);
        const QPicture drawn = picture(kSaved_px);
        QPainter(&svg).drawPicture(0, 0, drawn);
    } else if (!path.isEmpty()) {
        plot_->savePng(path, kSaved_px.width(), kSaved_px.height());
    }
}

}  // namespace pmts::gui
