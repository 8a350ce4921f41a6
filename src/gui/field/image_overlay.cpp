#include "image_overlay.hpp"

#include "overlay_strokes.hpp"
#include "overlay_tools.hpp"
#include "pmts/gui/theme.hpp"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QPixmapCache>
#include <QTransform>

#include <cmath>

namespace pmts::gui {
namespace {

constexpr double kReticleGap = 6.0;
constexpr double kReticleArm = 34.0;
constexpr double kTargetRadius = 15.0;
constexpr double kStampSide = 32.0;

QPainterPath reticlePath(const QPointF& at) {
    QPainterPath path;
    for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        path.moveTo(at + arm * kReticleGap);
        path.lineTo(at + arm * kReticleArm);
    }
    path.addEllipse(at, 1.2, 1.2);
    return path;
}

QPainterPath tickPath(const QPointF& at) {
    QPainterPath path(at + QPointF(-kTargetRadius - 18, -10));
    path.lineTo(at + QPointF(-kTargetRadius - 12, -4));
    path.lineTo(at + QPointF(-kTargetRadius - 2, -18));
    return path;
}

QPainterPath arcPath(const QPointF& at) {
    const QRectF box(at - QPointF(kTargetRadius, kTargetRadius),
                     QSizeF(2 * kTargetRadius, 2 * kTargetRadius));
    QPainterPath path;
    path.arcMoveTo(box, 60);
    path.arcTo(box, 60, 270);
    const QPointF head = at + QPointF(kTargetRadius * std::cos(M_PI / 6), kTargetRadius * std::sin(M_PI / 6));
    path.moveTo(head + QPointF(-7, 3));
    path.lineTo(head);
    path.lineTo(head + QPointF(6, 6));
    return path;
}

void paintTargetShape(QPainter& painter, const ImageOverlay::Target& target, const QPointF& at,
                      const Theme& theme) {
    const Theme& states = themeNamed(PaletteName::kNight);  // pictures are dark ground whatever the palette
    switch (target.look) {
        case TargetLook::kClicked:
            strokeEdged(painter, circlePath(at, kTargetRadius), theme.overlay_light, theme);
            strokeEdged(painter, circlePath(at, 1.5), theme.overlay_light, theme);
            break;
        case TargetLook::kQueued:
            strokeEdged(painter, circlePath(at, kTargetRadius), theme.overlay_dark, theme, Qt::DashLine);
            break;
        case TargetLook::kTurning:
            strokeEdged(painter, arcPath(at), themeNamed(PaletteName::kDay).busy, theme);
            break;
        case TargetLook::kRecentring:
            strokeEdged(painter, arcPath(at), themeNamed(PaletteName::kDay).busy, theme);
            strokeEdged(painter, circlePath(at, kTargetRadius / 2), states.warning, theme, Qt::DashLine);
            break;
        case TargetLook::kArrived:
            strokeEdged(painter, circlePath(at, kTargetRadius), states.good, theme);
            strokeEdged(painter, tickPath(at), states.good, theme);
            break;
        case TargetLook::kLost:
            strokeEdged(painter, boxPath(at, kTargetRadius), themeNamed(PaletteName::kDay).failed, theme);
            strokeEdged(painter, crossPath(at, kTargetRadius - 5), themeNamed(PaletteName::kDay).failed,
                        theme);
            break;
    }
}

void paintTarget(QPainter& painter, const ImageOverlay::Target& target, const QPointF& at,
                 const Theme& theme) {
    paintTargetShape(painter, target, at, theme);
    const double line = QFontMetricsF(painter.font()).height();
    QPointF text_at = at + QPointF(-kTargetRadius, kTargetRadius + line + 2);
    if (text_at.y() + 2 * line > painter.window().bottom()) {
        text_at.setY(at.y() - kTargetRadius - 2 * line);
    }
    drawEdgedText(painter, text_at, targetText(target.look), theme);
    if (!target.note.isEmpty()) {
        drawEdgedText(painter, text_at + QPointF(0, line), target.note, theme);
    }
}

QPainterPath symbolOf(PointLook look, const QPointF& at, bool selected) {
    const double reach = selected ? 8 : 6;
    switch (look) {
        case PointLook::kRecorded:
            return crossPath(at, reach);
        case PointLook::kPlanned:
            return diamondPath(at, reach + 2);
        case PointLook::kMark:
            break;
    }
    QPainterPath flag(at);
    flag.lineTo(at + QPointF(0, -13));
    flag.lineTo(at + QPointF(9, -9.5));
    flag.lineTo(at + QPointF(0, -6));
    flag.addEllipse(at, 1.0, 1.0);
    return flag;
}

QColor colorOf(PointLook look, bool selected) {
    if (selected) {
        return QColor(0xffd24a);
    }
    switch (look) {
        case PointLook::kRecorded:
            return themeNamed(PaletteName::kNight).good;
        case PointLook::kPlanned:
            return QColor(0x9a4dff);
        case PointLook::kMark:
            break;
    }
    return themeNamed(PaletteName::kNight).accent;
}

/// A point's symbol, drawn once for the same reason as the letters; its centre is the middle of the picture.
QPixmap pointStamp(PointLook look, bool selected, double ratio, const Theme& theme) {
    const QString key = QStringLiteral("pmts/point/%1/%2/%3/%4")
                            .arg(static_cast<int>(look))
                            .arg(selected)
                            .arg(ratio)
                            .arg(static_cast<int>(theme.name));
    QPixmap drawn;
    if (QPixmapCache::find(key, &drawn)) {
        return drawn;
    }
    drawn = QPixmap((QSizeF(kStampSide, kStampSide) * ratio).toSize());
    drawn.setDevicePixelRatio(ratio);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    painter.setRenderHint(QPainter::Antialiasing);
    strokeEdged(painter, symbolOf(look, QPointF(kStampSide, kStampSide) / 2, selected),
                colorOf(look, selected), theme);
    painter.end();
    QPixmapCache::insert(key, drawn);
    return drawn;
}

void paintPoints(QPainter& painter, const std::vector<ImageOverlay::Point>& points,
                 const QTransform& widget_from_image, const Theme& theme) {
    const double ratio = painter.device()->devicePixelRatioF();
    for (const ImageOverlay::Point& point : points) {
        const QPointF at = widget_from_image.map(point.px);
        painter.drawPixmap(at - QPointF(kStampSide, kStampSide) / 2,
                           pointStamp(point.look, point.selected, ratio, theme));
        if (!point.label.isEmpty()) {
            drawEdgedText(painter, at + QPointF(11, -7), point.label, theme);
        }
    }
}

}  // namespace

QString targetText(TargetLook look) {
    switch (look) {
        case TargetLook::kClicked:
            return QCoreApplication::translate("Target", "target");
        case TargetLook::kQueued:
            return QCoreApplication::translate("Target", "queued");
        case TargetLook::kTurning:
            return QCoreApplication::translate("Target", "turning");
        case TargetLook::kRecentring:
            return QCoreApplication::translate("Target", "re-centring");
        case TargetLook::kArrived:
            return QCoreApplication::translate("Target", "arrived");
        case TargetLook::kLost:
            break;
    }
    return QCoreApplication::translate("Target", "lost");
}

void paintOverlay(QPainter& painter, const ImageOverlay& overlay, const QTransform& widget_from_image,
                  const Theme& theme) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setBold(true);
    painter.setFont(font);
    paintParallax(painter, overlay, widget_from_image, theme);
    paintPoints(painter, overlay.points, widget_from_image, theme);
    if (overlay.reticle) {
        strokeEdged(painter, reticlePath(widget_from_image.map(*overlay.reticle)), QColor(0xd40000), theme);
    }
    if (overlay.target) {
        paintTarget(painter, *overlay.target, widget_from_image.map(overlay.target->px), theme);
    }
    painter.restore();
}

void paintPlate(QPainter& painter, const QRect& area, Qt::Alignment alignment, const QString& text,
                const Theme& theme) {
    const QRect wanted =
        painter.fontMetrics().boundingRect(area.adjusted(12, 8, -12, -8), Qt::TextWordWrap, text);
    const QSize size = wanted.size() + QSize(16, 8);
    QRect plate(QPoint(), size);
    const QRect inner = area.adjusted(4, 4, -4, -4);
    plate.moveLeft(alignment & Qt::AlignRight     ? inner.right() - size.width() + 1
                   : alignment & Qt::AlignHCenter ? inner.center().x() - size.width() / 2
                                                  : inner.left());
    plate.moveTop(alignment & Qt::AlignBottom    ? inner.bottom() - size.height() + 1
                  : alignment & Qt::AlignVCenter ? inner.center().y() - size.height() / 2
                                                 : inner.top());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme.overlay_light, 1));
    painter.setBrush(theme.overlay_dark);
    painter.drawRoundedRect(QRectF(plate).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.drawText(plate, Qt::AlignCenter | Qt::TextWordWrap, text);
    painter.restore();
}

}  // namespace pmts::gui
