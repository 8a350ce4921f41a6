#include "line_grid.hpp"

#include "field/overlay_strokes.hpp"
#include "pmts/gui/theme.hpp"

#include <QPainter>
#include <QPainterPath>
#include <QTransform>

#include <cmath>

namespace pmts::gui {
namespace {

constexpr int kCircleEvery = 3;  ///< spacings between two circles
constexpr double kThinnest = 0.35;  ///< opacity
constexpr double kEdge_px = 2.2, kHair_px = 0.9;  ///< in every palette: thicker ones hide the target

/// A dark and a light hair beside one another read on any ground and hide little.
void hairs(QPainter& painter, const QPainterPath& path, const Theme& theme) {
    QColor dark = theme.overlay_dark, light = theme.overlay_light;
    dark.setAlphaF(kThinnest);
    light.setAlphaF(2 * kThinnest);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(dark, kEdge_px));
    painter.drawPath(path);
    painter.setPen(QPen(light, kHair_px));
    painter.drawPath(path);
}

}  // namespace

void paintLineGrid(QPainter& painter, const QTransform& widget_from_frame, const LineGrid& grid, const Theme& theme) {
    if (grid.size.isEmpty() || grid.spacing_px < 1) {
        return;
    }
    const QRectF picture(-0.5, -0.5, grid.size.width(), grid.size.height());
    QPainterPath lines;
    const auto add = [&lines](const QPointF& from, const QPointF& to) {
        lines.moveTo(from);
        lines.lineTo(to);
    };
    const double first_x = grid.centre.x() - std::floor((grid.centre.x() - picture.left()) / grid.spacing_px) * grid.spacing_px;
    for (double x = first_x; x < picture.right(); x += grid.spacing_px) {
        add({x, picture.top()}, {x, picture.bottom()});
    }
    const double first_y = grid.centre.y() - std::floor((grid.centre.y() - picture.top()) / grid.spacing_px) * grid.spacing_px;
    for (double y = first_y; y < picture.bottom(); y += grid.spacing_px) {
        add({picture.left(), y}, {picture.right(), y});
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath frame;
    frame.addRect(widget_from_frame.mapRect(picture));
    painter.setClipPath(frame, Qt::IntersectClip);
    hairs(painter, widget_from_frame.map(lines), theme);
    QPainterPath circles;
    const double reach = std::hypot(grid.size.width(), grid.size.height()) / 2;
    for (double radius = kCircleEvery * grid.spacing_px; radius < reach; radius += kCircleEvery * grid.spacing_px) {
        circles.addEllipse(grid.centre, radius, radius);
    }
    hairs(painter, widget_from_frame.map(circles), theme);
    QPainterPath cross;
    cross.moveTo(grid.centre - QPointF(grid.spacing_px / 2, 0));
    cross.lineTo(grid.centre + QPointF(grid.spacing_px / 2, 0));
    cross.moveTo(grid.centre - QPointF(0, grid.spacing_px / 2));
    cross.lineTo(grid.centre + QPointF(0, grid.spacing_px / 2));
    strokeEdged(painter, widget_from_frame.map(cross), theme.accent, theme);
    painter.restore();
}

}  // namespace pmts::gui
