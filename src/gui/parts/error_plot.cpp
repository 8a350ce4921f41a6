#include "error_plot.hpp"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kArrowShare = 0.2;  ///< of the image's width: the longest arrow
constexpr double kBarWidth = 0.36;
constexpr double kBarMargin = 0.06;   ///< of the range, below the bars
constexpr double kLegendRoom = 0.45;  ///< and above them
constexpr double kReach_px = 14.0;    ///< of the hover

double largestError(const app::MethodPage& page) {
    double largest = 0.0;
    for (const app::TargetError& error : page.errors) {
        largest = std::max(largest, std::hypot(error.ha, error.va));
    }
    return largest;
}

}  // namespace

ErrorPlot::ErrorPlot(QWidget* parent) : PlotWidget(QStringLiteral("errors"), parent) {}

void ErrorPlot::showBars(const app::MethodPage& page, const QString& unit) { showVectors(page, {}, unit); }

void ErrorPlot::showVectors(const app::MethodPage& page, const QSize& image_px, const QString& unit) {
    page_ = page;
    unit_ = unit;
    image_px_ = image_px;
    redraw();
}

void ErrorPlot::draw() { image_px_.isEmpty() ? drawBars() : drawVectors(); }

void ErrorPlot::drawBars() {
    const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
    QVector<double> places, ha, va;
    for (const app::TargetError& error : page_.errors) {
        places.append(static_cast<double>(places.size()));
        ha.append(error.ha);
        va.append(error.va);
        names->addTick(places.back(), error.name);
    }
    const auto bars = [&](const QString& name, double shift, const QBrush& brush, const QColor& edge, const QVector<double>& values) {
        auto* const made = new QCPBars(canvas().xAxis, canvas().yAxis);
        QVector<double> shifted = places;
        std::ranges::transform(shifted, shifted.begin(), [shift](double place) { return place + shift; });
        made->setName(name);
        made->setWidth(kBarWidth);
        made->setBrush(brush);
        made->setPen(QPen(edge, look().line_px));
        made->setData(shifted, values, true);
    };
    bars(tr("HA"), -kBarWidth / 2, look().ha, look().ha, ha);
    bars(tr("VA"), kBarWidth / 2, QBrush(look().va, Qt::BDiagPattern), look().va, va);  // told apart without colour
    canvas().xAxis->setTicker(names);
    canvas().xAxis->setLabel(tr("Target"));
    canvas().yAxis->grid()->setZeroLinePen(QPen(look().text, look().line_px));
    canvas().yAxis->setLabel(tr("Error [%1]").arg(unit_));
    canvas().xAxis->setRange(-0.6, static_cast<double>(places.size()) - 0.4);
    canvas().yAxis->rescale();
    const QCPRange reach = canvas().yAxis->range();
    canvas().yAxis->setRange(std::min(0.0, reach.lower) - kBarMargin * reach.size(),
                           std::max(0.0, reach.upper) + kLegendRoom * reach.size());
    canvas().axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignRight);
    canvas().legend->setFillOrder(QCPLegend::foColumnsFirst);
    canvas().legend->setVisible(true);
}

void ErrorPlot::drawLabelled(const QPointF& from, const QPointF& to, const QString& label) {
    addArrow(from, to, QPen(look().ha, 2 * look().line_px));
    auto* const text = new QCPItemText(&canvas());
    text->position->setCoords(from);
    text->setPositionAlignment(Qt::AlignBottom | Qt::AlignHCenter);
    text->setPadding(QMargins(0, 0, 0, 3));
    text->setText(label);
    text->setColor(look().text);
    text->setFont(font());
}

void ErrorPlot::drawVectors() {
    drawFrame(image_px_, tr("Column [px]; arrows: HA right, VA down"));
    QVector<double> columns, rows;
    const double largest = largestError(page_);
    const double px_per_unit = largest > 0 ? kArrowShare * image_px_.width() / largest : 0.0;
    for (const app::TargetError& error : page_.errors) {
        columns.append(error.px.x());
        rows.append(error.px.y());
        drawLabelled(error.px, error.px + QPointF(error.ha, error.va) * px_per_unit, error.name);
    }
    addDots(columns, rows, QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(look().text, look().line_px), look().ground, 6));
    if (largest > 0) {
        const double shown = roundBelow(largest);
        const QPointF foot(0.08 * image_px_.width(), 0.95 * image_px_.height());
        drawLabelled(foot, foot + QPointF(shown * px_per_unit, 0), QStringLiteral("%1 %2").arg(shown).arg(unit_));
    }
}

QString ErrorPlot::textAt(const QPoint& at) const {
    const auto distance = [&](const app::TargetError& error, std::size_t index) {
        const double across = plot().xAxis->coordToPixel(image_px_.isEmpty() ? static_cast<double>(index) : error.px.x()) - at.x();
        return image_px_.isEmpty() ? std::abs(across) : std::hypot(across, plot().yAxis->coordToPixel(error.px.y()) - at.y());
    };
    const app::TargetError* nearest = nullptr;
    double least = kReach_px;
    for (std::size_t i = 0; i < page_.errors.size(); ++i) {
        if (const double away = distance(page_.errors[i], i); away <= least) {
            least = away;
            nearest = &page_.errors[i];
        }
    }
    return nearest == nullptr ? QString()
                              : tr("%1: error HA %2 %4, VA %3 %4").arg(nearest->name).arg(nearest->ha, 0, 'f', 4).arg(nearest->va, 0, 'f', 4).arg(unit_);
}

QString ErrorPlot::csv() const {
    QString text = QStringLiteral("target,error_ha_%1,error_va_%1,column_px,row_px\n").arg(unit_);
    for (const app::TargetError& error : page_.errors) {
        text += QStringLiteral("%1,%2,%3,%4,%5\n")
                    .arg(csvCell(error.name))
                    .arg(error.ha, 0, 'f', 6)
                    .arg(error.va, 0, 'f', 6)
                    .arg(error.px.x(), 0, 'f', 3)
                    .arg(error.px.y(), 0, 'f', 3);
    }
    return text;
}

}  // namespace pmts::gui
