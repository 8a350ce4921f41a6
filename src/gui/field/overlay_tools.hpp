#pragma once

#include "image_overlay.hpp"

#include <QLineF>
#include <QRectF>

namespace pmts::gui {

/// What a click would snap to; each with a shape and a word of its own.
enum class SnapLook { kCorner, kCrossing, kCircle, kEllipse };

[[nodiscard]] QString snapText(SnapLook look);

/// What the tools in hand draw over a picture, pixels of the image.
struct ToolOverlay {
    struct Snap {
        QPointF px;
        SnapLook look = SnapLook::kCorner;
        QPointF half_axes_px{};       ///< of a circle or ellipse, the longer first
        double axis_angle_rad = 0.0;  ///< of the longer axis, clockwise from right
    };

    std::optional<Snap> snap{};
    std::optional<QLineF> drag{};  ///< from the grabbed spot to where it would come
    std::optional<QRectF> box{};   ///< being drawn
};

void paintTools(QPainter& painter, const ToolOverlay& tools, const QTransform& widget_from_image,
                const Theme& theme);
/// The curve with its labels: a share of paintOverlay().
void paintParallax(QPainter& painter, const ImageOverlay& overlay, const QTransform& widget_from_image,
                   const Theme& theme);

}  // namespace pmts::gui
