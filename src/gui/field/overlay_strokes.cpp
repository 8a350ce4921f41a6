#include "overlay_strokes.hpp"

#include "pmts/gui/theme.hpp"

#include <QFontMetricsF>
#include <QPainter>
#include <QPixmap>
#include <QPixmapCache>

namespace pmts::gui {
namespace {

constexpr double kTextEdge = 3.0;

/// Light letters with a dark edge. Stroking letters costs more than a frame has time for when many points are
/// labelled, so each text is drawn once.
QPixmap edgedText(const QString& text, const QFont& font, double ratio, const Theme& theme) {
    const QString key =
        QStringLiteral("pmts/%1/%2/%3/%4").arg(text, font.key()).arg(ratio).arg(static_cast<int>(theme.name));
    QPixmap drawn;
    if (QPixmapCache::find(key, &drawn)) {
        return drawn;
    }
    const QFontMetricsF metrics(font);
    const QSizeF size(metrics.horizontalAdvance(text) + 2 * kTextEdge, metrics.height() + 2 * kTextEdge);
    drawn = QPixmap((size * ratio).toSize() + QSize(1, 1));
    drawn.setDevicePixelRatio(ratio);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath letters;
    letters.addText(QPointF(kTextEdge, kTextEdge + metrics.ascent()), font, text);
    painter.strokePath(letters, QPen(theme.overlay_dark, 3.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(letters, theme.overlay_light);
    painter.end();
    QPixmapCache::insert(key, drawn);
    return drawn;
}

}  // namespace

void strokeEdged(QPainter& painter, const QPainterPath& path, const QColor& color, const Theme& theme,
                 Qt::PenStyle style) {
    const double width = 1.6 * theme.line_px;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.overlay_dark, width + 3.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(QPen(theme.overlay_light, width + 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(QPen(color, width, style, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPath(path);
}

void drawEdgedText(QPainter& painter, const QPointF& at, const QString& text, const Theme& theme) {
    const double ascent = QFontMetricsF(painter.font()).ascent();
    const double ratio = painter.device()->devicePixelRatioF();
    painter.drawPixmap(at - QPointF(kTextEdge, kTextEdge + ascent),
                       edgedText(text, painter.font(), ratio, theme));
}

QPainterPath crossPath(const QPointF& at, double reach) {
    QPainterPath path(at - QPointF(reach, reach));
    path.lineTo(at + QPointF(reach, reach));
    path.moveTo(at + QPointF(reach, -reach));
    path.lineTo(at + QPointF(-reach, reach));
    return path;
}

QPainterPath circlePath(const QPointF& at, double radius) {
    QPainterPath path;
    path.addEllipse(at, radius, radius);
    return path;
}

QPainterPath boxPath(const QPointF& at, double reach) {
    QPainterPath path;
    path.addRect(QRectF(at - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach)));
    return path;
}

QPainterPath diamondPath(const QPointF& at, double reach) {
    QPainterPath path(at + QPointF(0, -reach));
    path.lineTo(at + QPointF(reach, 0));
    path.lineTo(at + QPointF(0, reach));
    path.lineTo(at + QPointF(-reach, 0));
    path.closeSubpath();
    return path;
}

}  // namespace pmts::gui
