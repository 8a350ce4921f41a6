#include "histogram_view.hpp"

#include "pmts/gui/theme.hpp"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kEdge_px = 2.0;
constexpr double kPile = 0.005;  // at an end: worth a mark
constexpr int kQuarter = 64;

QColor channelColor(int channel, const Theme& theme) {
    const bool is_dark = theme.field.lightness() < 128;
    constexpr int kHues[] = {0, 120, 220};
    return QColor::fromHsl(kHues[channel], 220, is_dark ? 170 : 95);
}

QString percent(float share) { return QString::number(100.0 * static_cast<double>(share), 'f', 1); }

}  // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void HistogramView::showMeters(const camera::PictureMeters& meters) {
    meters_ = meters;
    update();
}

QRectF HistogramView::plot() const {
    const double below = fontMetrics().height() + kEdge_px;
    return QRectF(rect()).adjusted(kEdge_px, kEdge_px, -kEdge_px, -below);
}

QPolygonF HistogramView::line(const camera::Histogram& histogram, double highest) const {
    const QRectF area = plot();
    QPolygonF points;
    for (std::size_t level = 0; level < histogram.size(); ++level) {
        const double height = std::min(1.0, std::sqrt(static_cast<double>(histogram[level]) / highest));
        points << QPointF(area.left() + area.width() * static_cast<double>(level) / 255.0, area.bottom() - area.height() * height);
    }
    return points;
}

QString HistogramView::textAt(const QPointF& at) const {
    const QRectF area = plot();
    const int level = std::clamp(qRound(255.0 * (at.x() - area.left()) / area.width()), 0, 255);
    const auto index = static_cast<std::size_t>(level);
    return tr("level %1: brightness %2 %, red %3 %, green %4 %, blue %5 %")
        .arg(QString::number(level), percent(meters_.luma[index]), percent(meters_.red[index]), percent(meters_.green[index]),
             percent(meters_.blue[index]));
}

bool HistogramView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* const help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), textAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

void HistogramView::paintEvent(QPaintEvent*) {
    const Theme& theme = currentTheme();
    const QRectF area = plot();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(area, theme.field);
    painter.setPen(QPen(theme.border, 1));
    for (int level = kQuarter; level < 256; level += kQuarter) {
        const double x = area.left() + area.width() * level / 255.0;
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
    // The ends may be needles: the scale is that of the levels between them.
    const double highest = std::max(1e-6, static_cast<double>(*std::max_element(meters_.luma.begin() + 2, meters_.luma.end() - 2)));
    QPolygonF filled = line(meters_.luma, highest);
    filled << area.bottomRight() << area.bottomLeft();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.border);
    painter.drawPolygon(filled);
    painter.setBrush(Qt::NoBrush);
    const camera::Histogram* const channels[] = {&meters_.red, &meters_.green, &meters_.blue};
    for (int channel = 0; channel < 3; ++channel) {
        painter.setPen(QPen(channelColor(channel, theme), std::max(1.3, theme.line_px)));
        painter.drawPolyline(line(*channels[channel], highest));
    }
    painter.setPen(QPen(theme.text, theme.line_px));
    painter.drawPolyline(line(meters_.luma, highest));
    if (meters_.burnt_share > kPile) {
        painter.fillRect(QRectF(area.right() - 6, area.top(), 6, area.height()), QBrush(theme.failed, Qt::BDiagPattern));
    }
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area);
    const QRectF below(area.left(), area.bottom(), area.width(), height() - area.bottom());
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, tr("black"));
    painter.drawText(below, Qt::AlignHCenter | Qt::AlignVCenter, tr("grey value"));
    painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, tr("white"));
}

}  // namespace pmts::gui
