#include "loupe.hpp"

namespace pmts::gui {

Loupe::Loupe(QWidget* parent) : ImageView(parent) {
    setAccessibleName(tr("Loupe"));
    setObjectName(QStringLiteral("loupe"));
    setDragPolicy([](const QPointF&, Qt::KeyboardModifiers) { return DragUse::kNone; });
    connect(this, &ImageView::zoomChanged, this, &Loupe::showMagnification);
    setZoom(8.0);
}

void Loupe::showMagnification() {
    const QString times = QString::number(zoom(), 'g', 2);
    setCaption(place_ ? tr("%1x").arg(times) : QString());
    setNotice(place_ ? QString() : tr("Loupe %1x: move over a picture").arg(times));
}

void Loupe::showAround(camera::FramePtr frame, const QPointF& image_px) {
    const bool is_first = !place_;
    place_ = image_px;
    setFrame(std::move(frame));
    setCenter(image_px);
    if (is_first) {
        showMagnification();
    }
}

void Loupe::follow(camera::FramePtr frame) {
    if (place_) {
        setFrame(std::move(frame));
        setCenter(*place_);
    }
}

void Loupe::showOverlay(const ImageOverlay& of_picture) {
    ImageOverlay overlay{.reticle = place_, .points = of_picture.points, .target = of_picture.target};
    if (overlay.target) {
        overlay.target->note.clear();  // no room for HA and VA here
    }
    setOverlay(std::move(overlay));
}

void Loupe::zoomAbout(const QPointF&, double zoom) {
    const QPointF held = place_.value_or(QPointF());
    ImageView::zoomAbout(QPointF(width(), height()) / 2, zoom);
    setCenter(held);
}

}  // namespace pmts::gui
