#pragma once

#include <QPointF>
#include <QSize>

class QPainter;
class QTransform;

namespace pmts::gui {

struct Theme;

/// Lines through the principal point and every so many pixels beside it, and circles about it (thesis routine Pic9line).
struct LineGrid {
    QSize size;  ///< of the picture
    QPointF centre;
    double spacing_px = 30.0;
};

void paintLineGrid(QPainter& painter, const QTransform& widget_from_frame, const LineGrid& grid, const Theme& theme);

}  // namespace pmts::gui
