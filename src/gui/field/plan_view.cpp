#include "plan_view.hpp"

#include "pmts/gui/theme.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kPick_px = 16.0;
constexpr double kMargin_px = 46.0;
constexpr double kLeastExtent_m = 4.0;
constexpr double kLargestScale = 20000.0;  ///< pixels a metre
constexpr double kSmallestScale = 0.005;
constexpr double kFootPerMetre = 1.0 / 0.3048;

QTransform transformFor(const QPointF& center_en_m, double px_per_m, QSize widget) {
    return {px_per_m,
            0,
            0,
            -px_per_m,
            widget.width() / 2.0 - center_en_m.x() * px_per_m,
            widget.height() / 2.0 + center_en_m.y() * px_per_m};
}

}  // namespace

double niceLength(double at_most) {
    const double decade = std::pow(10.0, std::floor(std::log10(at_most)));
    for (const double step : {5.0, 2.0}) {
        if (step * decade <= at_most) {
            return step * decade;
        }
    }
    return decade;
}

PlanView::PlanView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::ClickFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    fit();
}

void PlanView::showScene(app::PlanScene scene) {
    scene_ = std::move(scene);
    if (fitted_) {
        fit();
    }
    update();
}

void PlanView::setUnits(const app::UnitFormat& units) {
    units_ = units;
    update();
}

void PlanView::selectPoint(qint64 row_id) {
    selected_ = row_id;
    update();
}

void PlanView::selectPlanned(qint64 row_id) {
    selected_planned_ = row_id;
    update();
}

void PlanView::fit() {
    QRectF ground(scene_.station_en_m, QSizeF(0, 0));
    for (const auto* points : {&scene_.points, &scene_.planned}) {
        for (const app::PlanPoint& point : *points) {
            ground.setLeft(std::min(ground.left(), point.position_en_m.x()));
            ground.setRight(std::max(ground.right(), point.position_en_m.x()));
            ground.setTop(std::min(ground.top(), point.position_en_m.y()));
            ground.setBottom(std::max(ground.bottom(), point.position_en_m.y()));
        }
    }
    const double wide_m = std::max(ground.width(), kLeastExtent_m);
    const double high_m = std::max(ground.height(), kLeastExtent_m);
    const double scale = std::min(std::max(20.0, width() - 2 * kMargin_px) / wide_m,
                                  std::max(20.0, height() - 2 * kMargin_px) / high_m);
    widget_from_ground_ = transformFor(ground.center(), scale, size());
    fitted_ = true;
    update();
}

void PlanView::zoomBy(double factor) { zoomAbout(QPointF(width(), height()) / 2, factor); }

void PlanView::zoomAbout(const QPointF& at, double factor) {
    const double now = widget_from_ground_.m11();
    const double wanted = std::clamp(now * factor, kSmallestScale, kLargestScale);
    const QPointF held = groundFromWidget(at);
    const QPointF center = held + QPointF(width() / 2.0 - at.x(), -(height() / 2.0 - at.y())) / wanted;
    widget_from_ground_ = transformFor(center, wanted, size());
    fitted_ = false;
    update();
}

void PlanView::resizeEvent(QResizeEvent* event) {
    if (fitted_) {
        fit();
    } else {
        const QPointF moved =
            QPointF(width() - event->oldSize().width(), height() - event->oldSize().height()) / 2;
        widget_from_ground_ *= QTransform::fromTranslate(moved.x(), moved.y());
    }
}

void PlanView::wheelEvent(QWheelEvent* event) {
    zoomAbout(event->position(), wheelZoom(*event));
    event->accept();
}

const app::PlanPoint* PlanView::nearestOf(const std::vector<app::PlanPoint>& points,
                                          const QPointF& at) const {
    const app::PlanPoint* nearest = nullptr;
    double nearest_px = kPick_px;
    for (const app::PlanPoint& point : points) {
        const QPointF off = widgetFromGround(point.position_en_m) - at;
        const double px = std::hypot(off.x(), off.y());
        if (px < nearest_px) {
            nearest_px = px;
            nearest = &point;
        }
    }
    return nearest;
}

void PlanView::mousePressEvent(QMouseEvent* event) {
    drag_.press(event->position());
}

void PlanView::mouseMoveEvent(QMouseEvent* event) {
    if (drag_.isPressed() && event->buttons()) {
        if (const QPointF moved = drag_.moved(event->position()); !moved.isNull()) {
            widget_from_ground_ *= QTransform::fromTranslate(moved.x(), moved.y());
            fitted_ = false;
            update();
        }
        return;
    }
    const QPointF en_m = groundFromWidget(event->position());
    const app::PlanPoint* const measured = nearestOf(scene_.points, event->position());
    const app::PlanPoint* const point = measured ? measured : nearestOf(scene_.planned, event->position());
    QString text = QStringLiteral("E %1  N %2").arg(units_.length(en_m.x()), units_.length(en_m.y()));
    if (point != nullptr) {
        text = QStringLiteral("%1 %2   ").arg(point->id, point->code) + text;
    }
    Q_EMIT hovered(text);
}

void PlanView::mouseReleaseEvent(QMouseEvent* event) {
    if (!drag_.release()) {
        return;
    }
    if (const app::PlanPoint* const point = nearestOf(scene_.points, event->position())) {
        selectPoint(point->row_id);
        Q_EMIT pointClicked(point->row_id);
    } else if (const app::PlanPoint* const planned = nearestOf(scene_.planned, event->position())) {
        selectPlanned(planned->row_id);
        Q_EMIT plannedClicked(planned->row_id);
    }
}

void PlanView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const app::PlanPoint* const point = nearestOf(scene_.points, event->position())) {
        Q_EMIT pointDoubleClicked(point->row_id);
    } else if (const app::PlanPoint* const planned = nearestOf(scene_.planned, event->position())) {
        Q_EMIT plannedDoubleClicked(planned->row_id);
    }
}

void PlanView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme& theme = currentTheme();
    painter.fillRect(rect(), theme.field);
    painter.setRenderHint(QPainter::Antialiasing);
    if (scene_.sight_en_m) {
        painter.setPen(QPen(theme.accent, 1.4 * theme.line_px, Qt::DashLine));
        painter.drawLine(widgetFromGround(scene_.station_en_m), widgetFromGround(*scene_.sight_en_m));
        painter.setPen(QPen(theme.accent, 1.6 * theme.line_px));
        painter.drawEllipse(widgetFromGround(*scene_.sight_en_m), 5, 5);
    }
    paintPlanned(painter);
    paintPoints(painter);
    paintStation(painter);
    paintNorth(painter);
    paintScaleBar(painter);
}

/// Hollow diamonds with slanted labels below: told apart from what was measured without colour.
void PlanView::paintPlanned(QPainter& painter) const {
    const Theme& theme = currentTheme();
    QFont slanted = font();
    slanted.setItalic(true);
    painter.setFont(slanted);
    const QFontMetricsF metrics(slanted);
    std::vector<QRectF> written;
    for (const app::PlanPoint& point : scene_.planned) {
        const QPointF at = widgetFromGround(point.position_en_m);
        if (!QRectF(rect()).adjusted(-20, -20, 20, 20).contains(at)) {
            continue;
        }
        const bool selected = point.row_id == selected_planned_;
        painter.setPen(QPen(selected ? theme.accent : theme.text, (selected ? 2.2 : 1.4) * theme.line_px));
        const double half = selected ? 7 : 5;
        painter.drawPolygon(QPolygonF{at + QPointF(0, -half), at + QPointF(half, 0), at + QPointF(0, half),
                                      at + QPointF(-half, 0)});
        const QRectF label(at + QPointF(7, 4),
                           QSizeF(metrics.horizontalAdvance(point.id) + 2, metrics.height()));
        const bool free =
            std::ranges::none_of(written, [&](const QRectF& other) { return other.intersects(label); });
        if (free || selected) {
            written.push_back(label);
            painter.setPen(theme.text);
            painter.drawText(label, Qt::AlignLeft | Qt::AlignVCenter, point.id);
        }
    }
    painter.setFont(font());
}

void PlanView::paintPoints(QPainter& painter) const {
    const Theme& theme = currentTheme();
    const QFontMetricsF metrics(painter.font());
    std::vector<QRectF> written;
    for (const app::PlanPoint& point : scene_.points) {
        const QPointF at = widgetFromGround(point.position_en_m);
        if (!QRectF(rect()).adjusted(-20, -20, 20, 20).contains(at)) {
            continue;
        }
        painter.setPen(QPen(point.absurd ? theme.failed : theme.text, 1.6 * theme.line_px));
        painter.drawLine(at - QPointF(4, 0), at + QPointF(4, 0));
        painter.drawLine(at - QPointF(0, 4), at + QPointF(0, 4));
        if (point.row_id == selected_) {
            painter.setPen(QPen(theme.accent, 2.2 * theme.line_px));
            painter.drawEllipse(at, 9, 9);
        }
        const QRectF label(at + QPointF(7, -4 - metrics.height()),
                           QSizeF(metrics.horizontalAdvance(point.id) + 2, metrics.height()));
        const bool free =
            std::ranges::none_of(written, [&](const QRectF& other) { return other.intersects(label); });
        if (free || point.row_id == selected_) {
            written.push_back(label);
            painter.setPen(theme.text);
            painter.drawText(label, Qt::AlignLeft | Qt::AlignVCenter, point.id);
        }
    }
}

void PlanView::paintStation(QPainter& painter) const {
    const Theme& theme = currentTheme();
    const QPointF at = widgetFromGround(scene_.station_en_m);
    QPainterPath triangle(at + QPointF(0, -10));
    triangle.lineTo(at + QPointF(9, 6));
    triangle.lineTo(at + QPointF(-9, 6));
    triangle.closeSubpath();
    painter.setPen(QPen(theme.accent, 2.0 * theme.line_px));
    painter.setBrush(theme.field);
    painter.drawPath(triangle);
    painter.setBrush(theme.accent);
    painter.drawEllipse(at, 1.5, 1.5);
    painter.setBrush(Qt::NoBrush);
    QFont bold = painter.font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(theme.text);
    painter.drawText(at + QPointF(12, 6 + QFontMetricsF(bold).ascent()), scene_.station_name);
    painter.setFont(font());
}

void PlanView::paintNorth(QPainter& painter) const {
    const Theme& theme = currentTheme();
    const QPointF tip(width() - 24.0, 14.0);
    QPainterPath arrow(tip);
    arrow.lineTo(tip + QPointF(8, 26));
    arrow.lineTo(tip + QPointF(0, 20));
    arrow.lineTo(tip + QPointF(-8, 26));
    arrow.closeSubpath();
    painter.setPen(QPen(theme.text, theme.line_px));
    painter.setBrush(theme.text);
    painter.drawPath(arrow);
    painter.setBrush(Qt::NoBrush);
    painter.drawText(QRectF(tip.x() - 12, tip.y() + 28, 24, painter.fontMetrics().height()), Qt::AlignCenter,
                     tr("N"));
}

void PlanView::paintScaleBar(QPainter& painter) const {
    const Theme& theme = currentTheme();
    const bool feet = units_.length_unit != app::LengthUnit::kMetre;
    const double per_m = feet ? kFootPerMetre : 1.0;
    const double px_per_unit = widget_from_ground_.m11() / per_m;
    const double length = niceLength(width() / 3.0 / px_per_unit);
    const double wide = length * px_per_unit;
    const QPointF left(14.0, height() - 14.0);
    painter.setPen(QPen(theme.text, 2.0 * theme.line_px));
    painter.drawLine(left, left + QPointF(wide, 0));
    painter.drawLine(left, left - QPointF(0, 6));
    painter.drawLine(left + QPointF(wide, 0), left + QPointF(wide, -6));
    painter.drawText(QRectF(left.x() + 4, left.y() - 4 - painter.fontMetrics().height(), std::max(wide, 80.0),
                            painter.fontMetrics().height()),
                     Qt::AlignLeft, QStringLiteral("%1 %2").arg(length).arg(units_.lengthUnitSign()));
}

}  // namespace pmts::gui
