#include "loupe.hpp"

#include "image_overlay.hpp"
#include "pmts/app/frame_image.hpp"
#include "pmts/gui/theme.hpp"

#include <QPainter>

namespace pmts::gui {

Loupe::Loupe(QWidget* parent) : QWidget(parent) { setAttribute(Qt::WA_OpaquePaintEvent); }

void Loupe::showAround(camera::FramePtr frame, const QPointF& image_px) {
    frame_ = std::move(frame);
    place_ = image_px;
    update();
}

void Loupe::setFrame(camera::FramePtr frame) {
    if (place_) {
        frame_ = std::move(frame);
        update();
    }
}

void Loupe::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme& theme = currentTheme();
    painter.fillRect(rect(), themeNamed(PaletteName::kNight).field);
    if (!frame_ || !place_) {
        paintPlate(painter, rect(), Qt::AlignHCenter | Qt::AlignVCenter, tr("Loupe 8x: move over a picture"),
                   theme);
        return;
    }
    const double s = kMagnification;
    const QPointF middle = QPointF(width(), height()) / 2.0;
    const QTransform widget_from_image(s, 0, 0, s, middle.x() - place_->x() * s,
                                       middle.y() - place_->y() * s);
    const QRect around =
        widget_from_image.inverted().mapRect(QRectF(rect())).toAlignedRect().adjusted(-1, -1, 1, 1);
    const QRect part = around.intersected(QRect(0, 0, frame_->image.cols, frame_->image.rows));
    if (!part.isEmpty()) {
        const QRectF edges(part.x() - 0.5, part.y() - 0.5, part.width(), part.height());
        painter.drawImage(widget_from_image.mapRect(edges), app::imageOfFrame(frame_), part);
    }
    paintOverlay(painter, {.reticle = *place_}, widget_from_image, theme);
}

}  // namespace pmts::gui
