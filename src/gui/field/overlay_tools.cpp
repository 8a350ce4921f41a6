#include "overlay_tools.hpp"

#include "overlay_strokes.hpp"
#include "pmts/gui/theme.hpp"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>

#include <algorithm>
#include <numbers>

namespace pmts::gui {
namespace {

constexpr double kSnapReach = 11.0;
constexpr double kLeastRound = 7.0;  ///< widget pixels: a smaller circle would hide under its centre
constexpr double kTick = 4.0;
constexpr double kBesideReticle = 44.0;
constexpr double kLeastLabelled = 0.4;  ///< widget pixels per pixel of the picture
const QColor kSnapColor(0x00e5ff);
const QColor kParallaxColor(0xffd24a);

/// Two arms from the corner, open to the right and below.
QPainterPath cornerPath(const QPointF& at) {
    QPainterPath path(at + QPointF(kSnapReach, 0));
    path.lineTo(at);
    path.lineTo(at + QPointF(0, kSnapReach));
    path.addRect(QRectF(at - QPointF(kTick, kTick), QSizeF(2 * kTick, 2 * kTick)));
    return path;
}

QPainterPath roundPath(const ToolOverlay::Snap& snap, const QPointF& at, double scale) {
    const QPointF axes = snap.look == SnapLook::kCircle
                             ? QPointF(snap.half_axes_px.x(), snap.half_axes_px.x())
                             : snap.half_axes_px;
    QPainterPath outline;
    outline.addEllipse(QPointF(0, 0), std::max(kLeastRound, axes.x() * scale),
                       std::max(0.6 * kLeastRound, axes.y() * scale));
    const QTransform turn = QTransform().rotateRadians(snap.axis_angle_rad);
    return (outline + crossPath({}, kTick)) * turn * QTransform::fromTranslate(at.x(), at.y());
}

QPainterPath snapPath(const ToolOverlay::Snap& snap, const QPointF& at, double scale) {
    switch (snap.look) {
        case SnapLook::kCorner:
            return cornerPath(at);
        case SnapLook::kCrossing:
            return crossPath(at, kSnapReach) + diamondPath(at, kTick + 1);
        case SnapLook::kCircle:
        case SnapLook::kEllipse:
            break;
    }
    return roundPath(snap, at, scale);
}

void paintSnap(QPainter& painter, const ToolOverlay::Snap& snap, const QTransform& widget_from_image,
               const Theme& theme) {
    const QPointF at = widget_from_image.map(snap.px);
    strokeEdged(painter, snapPath(snap, at, widget_from_image.m11()), kSnapColor, theme);
    const QString word = snapText(snap.look);
    const double width = QFontMetricsF(painter.font()).horizontalAdvance(word);
    const bool fits = at.x() + kSnapReach + 6 + width < painter.window().right();
    drawEdgedText(painter, at + QPointF(fits ? kSnapReach + 4 : -kSnapReach - 4 - width, -kSnapReach), word,
                  theme);
}

/// A ring on the curve, and its length left of the reticle's arms with a thread between them.
void paintParallaxMark(QPainter& painter, const QPointF& at, double base_y, const QString& text,
                       const Theme& theme) {
    const QFontMetricsF metrics(painter.font());
    const QPointF end(at.x() - kBesideReticle, base_y - 0.35 * metrics.height());
    painter.setPen(QPen(theme.overlay_dark, 3));
    painter.drawLine(end, at);
    painter.setPen(QPen(kParallaxColor, 1));
    painter.drawLine(end, at);
    strokeEdged(painter, circlePath(at, 3.0), kParallaxColor, theme);
    drawEdgedText(painter, {end.x() - metrics.horizontalAdvance(text) - 4, base_y}, text, theme);
}

}  // namespace

QString snapText(SnapLook look) {
    switch (look) {
        case SnapLook::kCorner:
            return QCoreApplication::translate("Snap", "corner");
        case SnapLook::kCrossing:
            return QCoreApplication::translate("Snap", "crossing");
        case SnapLook::kCircle:
            return QCoreApplication::translate("Snap", "circle");
        case SnapLook::kEllipse:
            break;
    }
    return QCoreApplication::translate("Snap", "ellipse");
}

void paintParallax(QPainter& painter, const ImageOverlay& overlay, const QTransform& widget_from_image,
                   const Theme& theme) {
    if (overlay.parallax.size() < 2) {
        return;
    }
    QPainterPath curve(widget_from_image.map(overlay.parallax.front()));
    for (const QPointF& px : overlay.parallax) {
        curve.lineTo(widget_from_image.map(px));
    }
    strokeEdged(painter, curve, kParallaxColor, theme);
    if (widget_from_image.m11() < kLeastLabelled) {
        return;  // lengths in a thumbnail would hide the picture
    }
    std::vector<ImageOverlay::Label> labels = overlay.parallax_marks;
    std::ranges::sort(labels, {}, [&](const auto& label) { return widget_from_image.map(label.px).y(); });
    const double line = QFontMetricsF(painter.font()).height();
    double taken_to = -1e9;
    for (const ImageOverlay::Label& label : labels) {
        const QPointF at = widget_from_image.map(label.px);
        const double base =
            std::max(at.y() + 0.35 * line, taken_to + line);  // close ends: one below the other
        paintParallaxMark(painter, at, base, label.text, theme);
        taken_to = base;
    }
}

void paintTools(QPainter& painter, const ToolOverlay& overlay, const QTransform& widget_from_image,
                const Theme& theme) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setBold(true);
    painter.setFont(font);
    if (overlay.snap) {
        paintSnap(painter, *overlay.snap, widget_from_image, theme);
    }
    if (overlay.drag) {
        const QPointF from = widget_from_image.map(overlay.drag->p1());
        const QPointF to = widget_from_image.map(overlay.drag->p2());
        QPainterPath path = circlePath(from, 5.0);
        path.moveTo(from);
        path.lineTo(to);
        path.addEllipse(to, 9.0, 9.0);
        strokeEdged(painter, path, kSnapColor, theme);
    }
    if (overlay.box) {
        QPainterPath path;
        path.addRect(widget_from_image.mapRect(*overlay.box));
        strokeEdged(painter, path, kSnapColor, theme, Qt::DashLine);
    }
    painter.restore();
}

}  // namespace pmts::gui
