#pragma once

#include <QColor>
#include <QPainterPath>
#include <QPointF>
#include <QString>

class QPainter;

namespace pmts::gui {

struct Theme;

/// Strokes a path in `color` between a dark and a light edge: reads on any ground.
void strokeEdged(QPainter& painter, const QPainterPath& path, const QColor& color, const Theme& theme,
                 Qt::PenStyle style = Qt::SolidLine);

/// Light letters with a dark edge; `at` is the start of the base line.
void drawEdgedText(QPainter& painter, const QPointF& at, const QString& text, const Theme& theme);

[[nodiscard]] QPainterPath crossPath(const QPointF& at, double reach);
[[nodiscard]] QPainterPath circlePath(const QPointF& at, double radius);
[[nodiscard]] QPainterPath boxPath(const QPointF& at, double reach);
[[nodiscard]] QPainterPath diamondPath(const QPointF& at, double reach);

}  // namespace pmts::gui
