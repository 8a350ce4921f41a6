#include "error_plot.hpp"

#include "pmts/gui/theme.hpp"

#include <QContextMenuEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMenu>
#include <QSvgGenerator>
#include <QToolTip>
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

/// 1, 2 or 5 times a power of ten, not above the value.
double roundBelow(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double lead = value / power;
    return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

}  // namespace

PlotLook screenLook() {
    const Theme& theme = currentTheme();
    return {theme.field, theme.text, theme.border, theme.accent, theme.text, theme.line_px};
}

PlotLook paperLook() { return {Qt::white, Qt::black, QColor(0xb0, 0xb0, 0xb0), QColor(0x1b, 0x5e, 0xa8), Qt::black, 1.0}; }

ErrorPlot::ErrorPlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)), look_(screenLook()) {
    auto* const fill = new QHBoxLayout(this);
    fill->setContentsMargins(0, 0, 0, 0);
    fill->addWidget(plot_);
    plot_->setContextMenuPolicy(Qt::NoContextMenu);  // this widget's own
    connect(plot_, &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) { tellHovered(event->pos()); });
}

void ErrorPlot::showBars(const app::MethodPage& page, const QString& unit) {
    page_ = page;
    unit_ = unit;
    image_px_ = {};
    draw();
}

void ErrorPlot::showVectors(const app::MethodPage& page, const QSize& image_px, const QString& unit) {
    page_ = page;
    unit_ = unit;
    image_px_ = image_px;
    draw();
}

void ErrorPlot::setLook(const PlotLook& look) {
    look_ = look;
    follows_palette_ = false;
    draw();
}

void ErrorPlot::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    const bool other_look = event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange ||
                            event->type() == QEvent::FontChange;
    if (other_look && follows_palette_) {
        look_ = screenLook();
        draw();
    }
}

void ErrorPlot::resizeEvent(QResizeEvent*) {
    if (!image_px_.isEmpty()) {
        keepSquarePixels();
    }
}

void ErrorPlot::draw() {
    plot_->clearPlottables();
    plot_->clearItems();
    plot_->legend->setVisible(false);
    styleAxes();
    if (image_px_.isEmpty()) {
        drawBars();
    } else {
        drawVectors();
    }
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ErrorPlot::styleAxes() {
    plot_->setBackground(look_.ground);
    for (QCPAxis* const axis : {plot_->xAxis, plot_->yAxis}) {
        axis->setBasePen(QPen(look_.text, look_.line_px));
        axis->setTickPen(QPen(look_.text, look_.line_px));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(look_.text);
        axis->setLabelColor(look_.text);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->grid()->setPen(QPen(look_.grid, 1, Qt::DotLine));
        axis->grid()->setZeroLinePen(QPen(look_.text, look_.line_px));
        axis->setRangeReversed(false);
    }
    plot_->xAxis->grid()->setZeroLinePen(QPen(look_.grid, 1, Qt::DotLine));
    plot_->legend->setBrush(look_.ground);
    plot_->legend->setTextColor(look_.text);
    plot_->legend->setBorderPen(QPen(look_.grid, look_.line_px));
    plot_->legend->setFont(font());
    plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);
}

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
        auto* const made = new QCPBars(plot_->xAxis, plot_->yAxis);
        QVector<double> shifted = places;
        std::ranges::transform(shifted, shifted.begin(), [shift](double place) { return place + shift; });
        made->setName(name);
        made->setWidth(kBarWidth);
        made->setBrush(brush);
        made->setPen(QPen(edge, look_.line_px));
        made->setData(shifted, values, true);
    };
    bars(tr("HA"), -kBarWidth / 2, look_.ha, look_.ha, ha);
    bars(tr("VA"), kBarWidth / 2, QBrush(look_.va, Qt::BDiagPattern), look_.va, va);  // told apart without colour
    plot_->xAxis->setTicker(names);
    plot_->xAxis->setLabel(tr("Target"));
    plot_->yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTicker));
    plot_->yAxis->setLabel(tr("Error [%1]").arg(unit_));
    plot_->xAxis->setRange(-0.6, static_cast<double>(places.size()) - 0.4);
    plot_->yAxis->rescale();
    const QCPRange reach = plot_->yAxis->range();
    plot_->yAxis->setRange(std::min(0.0, reach.lower) - kBarMargin * reach.size(),
                           std::max(0.0, reach.upper) + kLegendRoom * reach.size());
    plot_->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignRight);
    plot_->legend->setVisible(true);
}

void ErrorPlot::drawArrow(const QPointF& from, const QPointF& to, const QString& label) {
    auto* const arrow = new QCPItemLine(plot_);
    arrow->start->setCoords(from);
    arrow->end->setCoords(to);
    arrow->setPen(QPen(look_.ha, 2 * look_.line_px));
    arrow->setHead(QCPLineEnding(QCPLineEnding::esSpikeArrow, 6, 8));
    auto* const text = new QCPItemText(plot_);
    text->position->setCoords(from);
    text->setPositionAlignment(Qt::AlignBottom | Qt::AlignHCenter);
    text->setPadding(QMargins(0, 0, 0, 3));
    text->setText(label);
    text->setColor(look_.text);
    text->setFont(font());
}

void ErrorPlot::drawVectors() {
    auto* const frame = new QCPItemRect(plot_);
    frame->topLeft->setCoords(-0.5, -0.5);
    frame->bottomRight->setCoords(image_px_.width() - 0.5, image_px_.height() - 0.5);
    frame->setPen(QPen(look_.text, look_.line_px));
    frame->setBrush(Qt::NoBrush);
    QVector<double> columns, rows;
    const double largest = largestError(page_);
    const double px_per_unit = largest > 0 ? kArrowShare * image_px_.width() / largest : 0.0;
    for (const app::TargetError& error : page_.errors) {
        columns.append(error.px.x());
        rows.append(error.px.y());
        drawArrow(error.px, error.px + QPointF(error.ha, error.va) * px_per_unit, error.name);
    }
    QCPGraph* const places = plot_->addGraph();
    places->setData(columns, rows);
    places->setLineStyle(QCPGraph::lsNone);
    places->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(look_.text, look_.line_px), look_.ground, 6));
    if (largest > 0) {
        const double shown = roundBelow(largest);
        const QPointF foot(0.03 * image_px_.width(), 0.95 * image_px_.height());
        drawArrow(foot, foot + QPointF(shown * px_per_unit, 0), QStringLiteral("%1 %2").arg(shown).arg(unit_));
    }
    plot_->xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTicker));
    plot_->yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTicker));
    plot_->xAxis->setLabel(tr("Column [px]; arrows: HA right, VA down"));
    plot_->yAxis->setLabel(tr("Row [px]"));
    plot_->yAxis->setRangeReversed(true);
    keepSquarePixels();
}

/// The whole image with a margin, as wide per pixel as high.
void ErrorPlot::keepSquarePixels() {
    const double margin = 0.04 * image_px_.width();
    plot_->xAxis->setRange(-margin, image_px_.width() + margin);
    plot_->yAxis->setRange(-margin, image_px_.height() + margin);
    const QSize room = plot_->axisRect()->size();
    if (room.isEmpty()) {
        return;
    }
    const double px_x = plot_->xAxis->range().size() / room.width();
    const double px_y = plot_->yAxis->range().size() / room.height();
    if (px_x > px_y) {
        plot_->yAxis->setScaleRatio(plot_->xAxis, 1.0);
    } else {
        plot_->xAxis->setScaleRatio(plot_->yAxis, 1.0);
    }
}

QPicture ErrorPlot::picture(const QSize& size) {
    QPicture drawn;
    QCPPainter painter;
    painter.begin(&drawn);
    painter.setMode(QCPPainter::pmVectorized);
    painter.setMode(QCPPainter::pmNoCaching);
    plot_->setGeometry(QRect(QPoint(), size));
    plot_->replot(QCustomPlot::rpImmediateRefresh);  // the layout at this size, for the square pixels
    if (!image_px_.isEmpty()) {
        keepSquarePixels();
    }
    plot_->toPainter(&painter, size.width(), size.height());
    painter.end();
    plot_->setGeometry(rect());
    return drawn;
}

void ErrorPlot::tellHovered(const QPoint& at) {
    const auto distance = [&](const app::TargetError& error, std::size_t index) {
        return image_px_.isEmpty() ? std::abs(plot_->xAxis->coordToPixel(static_cast<double>(index)) - at.x())
                                   : std::hypot(plot_->xAxis->coordToPixel(error.px.x()) - at.x(),
                                                plot_->yAxis->coordToPixel(error.px.y()) - at.y());
    };
    const app::TargetError* nearest = nullptr;
    double least = kReach_px;
    for (std::size_t i = 0; i < page_.errors.size(); ++i) {
        if (const double away = distance(page_.errors[i], i); away <= least) {
            least = away;
            nearest = &page_.errors[i];
        }
    }
    const QString text = nearest == nullptr ? QString()
                                            : tr("%1: error HA %2 %4, VA %3 %4")
                                                  .arg(nearest->name)
                                                  .arg(nearest->ha, 0, 'f', 4)
                                                  .arg(nearest->va, 0, 'f', 4)
                                                  .arg(unit_);
    QToolTip::showText(plot_->mapToGlobal(at), text, plot_);
}

void ErrorPlot::contextMenuEvent(QContextMenuEvent* event) {
    auto* const menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Save this plot…"), this, &ErrorPlot::save);
    menu->popup(event->globalPos());
}

void ErrorPlot::save() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save this plot"), {}, tr("Picture (*.svg *.png)"));
    if (path.endsWith(QStringLiteral(".svg"))) {
        QSvgGenerator file;
        file.setFileName(path);
        file.setSize(size());
        file.setViewBox(rect());
        const QPicture drawn = picture(size());
        QPainter(&file).drawPicture(0, 0, drawn);
    } else if (!path.isEmpty()) {
        plot_->savePng(path.endsWith(QStringLiteral(".png")) ? path : path + QStringLiteral(".png"), 0, 0, 2.0);
    }
}

}  // namespace pmts::gui
