#include "curve_plot.hpp"

#include <qcustomplot.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kReach_px = 14.0;
constexpr double kPoint_px = 6.0;
constexpr int kLegendIcon_px = 32;
constexpr double kLegendFont = 0.85;
constexpr double kHeadroom = 1.08;  ///< of the values' range
constexpr std::array kShapes{QCPScatterStyle::ssCircle, QCPScatterStyle::ssSquare, QCPScatterStyle::ssTriangle,
                             QCPScatterStyle::ssDiamond, QCPScatterStyle::ssCross, QCPScatterStyle::ssPlus};
constexpr std::array kLines{Qt::SolidLine, Qt::DashLine, Qt::DotLine};

}  // namespace

CurvePlot::CurvePlot(QWidget* parent) : PlotWidget(QStringLiteral("distortion"), parent) {}

void CurvePlot::showCurves(const std::vector<Curve>& curves, const QString& value_axis) {
    curves_ = curves;
    value_axis_ = value_axis;
    redraw();
}

void CurvePlot::draw() {
    if (curves_.empty()) {
        return drawNotice();
    }
    std::size_t measured = 0, computed = 0;
    for (const Curve& curve : curves_) {
        drawCurve(curve, curve.measured ? measured++ : computed++);
    }
    canvas().xAxis->setLabel(tr("pixels from the centre"));
    canvas().yAxis->setLabel(value_axis_);
    canvas().rescaleAxes();
    canvas().yAxis->scaleRange(kHeadroom);
    styleLegend();
}

/// In the corner that the curves leave free.
void CurvePlot::styleLegend() {
    QFont small = font();
    small.setPointSizeF(kLegendFont * small.pointSizeF());
    canvas().legend->setFont(small);
    canvas().legend->setIconSize(kLegendIcon_px, QFontMetrics(small).height());
    canvas().legend->setRowSpacing(0);
    canvas().legend->setVisible(curves_.size() > 1);
    const bool falls = std::ranges::any_of(curves_, [](const Curve& curve) {
        return !curve.value_gon.empty() && curve.value_gon.back() < curve.value_gon.front();
    });
    canvas().axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignBottom | (falls ? Qt::AlignLeft : Qt::AlignRight));
}

void CurvePlot::drawCurve(const Curve& curve, std::size_t turn) {
    QCPGraph* const graph = canvas().addGraph();
    graph->setName(curve.name);
    graph->setData(QVector<double>(curve.radius_px.begin(), curve.radius_px.end()),
                   QVector<double>(curve.value_gon.begin(), curve.value_gon.end()), true);
    if (curve.measured) {
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(QCPScatterStyle(kShapes[turn % kShapes.size()], QPen(look().ha, 1.5 * look().line_px), Qt::NoBrush, kPoint_px));
    } else {
        graph->setPen(QPen(turn == 0 ? look().ha : look().va, 1.5 * look().line_px, kLines[turn % kLines.size()]));
    }
}

QString CurvePlot::textAt(const QPoint& at) const {
    for (const Curve& curve : curves_) {
        for (std::size_t i = 0; i < curve.radius_px.size(); ++i) {
            const QPointF place(plot().xAxis->coordToPixel(curve.radius_px[i]), plot().yAxis->coordToPixel(curve.value_gon[i]));
            if (std::hypot(place.x() - at.x(), place.y() - at.y()) < kReach_px) {
                return tr("%1: %2 px, %3 gon").arg(curve.name).arg(curve.radius_px[i], 0, 'f', 1).arg(curve.value_gon[i], 0, 'f', 5);
            }
        }
    }
    return {};
}

QString CurvePlot::csv() const {
    QString text = QStringLiteral("curve,radius_px,value_gon\n");
    for (const Curve& curve : curves_) {
        for (std::size_t i = 0; i < curve.radius_px.size(); ++i) {
            text += QStringLiteral("%1,%2,%3\n").arg(csvCell(curve.name)).arg(curve.radius_px[i], 0, 'f', 3).arg(curve.value_gon[i], 0, 'f', 8);
        }
    }
    return text;
}

}  // namespace pmts::gui
