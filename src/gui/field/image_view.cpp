#include "image_view.hpp"

#include "pmts/gui/theme.hpp"

#include <QApplication>
#include <QGestureEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QPinchGesture>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pmts::gui {
namespace {

constexpr QSize kEmptySize(1280, 720);
constexpr double kWheelFactor = 1.25;

/// Whole pixels of the image that cover the widget, and where they go.
struct Visible {
    QRect part;    ///< image pixels
    QRectF place;  ///< widget coordinates
};

Visible visiblePart(const QTransform& widget_from_image, QSize widget, QSize image) {
    const QTransform image_from_widget = widget_from_image.inverted();
    // Edges, not centres: pixel i covers [i - 0.5, i + 0.5].
    const QPointF first = image_from_widget.map(QPointF(0, 0)) + QPointF(0.5, 0.5);
    const QPointF last = image_from_widget.map(QPointF(widget.width(), widget.height())) + QPointF(0.5, 0.5);
    const int left = std::clamp(static_cast<int>(std::floor(first.x())), 0, image.width() - 1);
    const int top = std::clamp(static_cast<int>(std::floor(first.y())), 0, image.height() - 1);
    const int right = std::clamp(static_cast<int>(std::ceil(last.x())), left + 1, image.width());
    const int bottom = std::clamp(static_cast<int>(std::ceil(last.y())), top + 1, image.height());
    const QRectF place(widget_from_image.map(QPointF(left - 0.5, top - 0.5)),
                       widget_from_image.map(QPointF(right - 0.5, bottom - 0.5)));
    return {QRect(left, top, right - left, bottom - top), place};
}

}  // namespace

ImageView::ImageView(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setFocusPolicy(Qt::ClickFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setCursor(Qt::CrossCursor);
    grabGesture(Qt::PinchGesture);
    center_px_ = QPointF(kEmptySize.width() - 1, kEmptySize.height() - 1) / 2;
}

void ImageView::setFrame(camera::FramePtr frame) {
    const QSize before = imageSize();
    frame_ = std::move(frame);
    shown_.reset();
    if (imageSize() != before) {
        center_px_ = QPointF(imageSize().width() - 1, imageSize().height() - 1) / 2;
        keepInside();
    }
    update();
}

void ImageView::setShown(camera::FramePtr shown) {
    shown_ = shown == frame_ ? nullptr : std::move(shown);
    update();
}

void ImageView::setOverlay(ImageOverlay overlay) {
    overlay_ = std::move(overlay);
    update();
}

void ImageView::setToolOverlay(const ToolOverlay& tools) {
    tools_ = tools;
    update();
}

void ImageView::setCenter(const QPointF& image_px) {
    center_px_ = image_px;
    keepInside();
    update();
}

void ImageView::setCaption(const QString& caption) {
    if (caption != caption_) {
        caption_ = caption;
        update();
    }
}

void ImageView::setNotice(const QString& notice) {
    if (notice != notice_) {
        notice_ = notice;
        update();
    }
}

void ImageView::setZoom(double zoom) { zoomAbout(QPointF(width(), height()) / 2, zoom); }

void ImageView::zoomAbout(const QPointF& widget_at, double zoom) {
    const QPointF held = imageFromWidget(widget_at);
    zoom_ = std::clamp(zoom, zoomLimits().first, zoomLimits().second);
    center_px_ = held - (widget_at - QPointF(width(), height()) / 2) / scale();
    keepInside();
    update();
    Q_EMIT zoomChanged(zoom_);
}

QSize ImageView::imageSize() const {
    return frame_ && !frame_->image.empty() ? QSize(frame_->image.cols, frame_->image.rows) : kEmptySize;
}

double ImageView::unzoomedScale() const {
    const QSize image = imageSize();
    return std::min(static_cast<double>(width()) / image.width(),
                    static_cast<double>(height()) / image.height());
}

double ImageView::scale() const { return std::max(unzoomedScale(), 1e-3) * zoom_; }

bool ImageView::isLargerThanWidget() const {
    const QSizeF shown = QSizeF(imageSize()) * scale();
    return shown.width() > width() + 1.0 || shown.height() > height() + 1.0;
}

QTransform ImageView::widgetFromImage() const {
    const double s = scale();
    return {s, 0, 0, s, width() / 2.0 - center_px_.x() * s, height() / 2.0 - center_px_.y() * s};
}

QPointF ImageView::widgetFromImage(const QPointF& image_px) const { return widgetFromImage().map(image_px); }

QPointF ImageView::imageFromWidget(const QPointF& widget_at) const {
    return widgetFromImage().inverted().map(widget_at);
}

QPointF ImageView::pixelUnderMouse(const QPointF& position) const {
    const double half = 0.5 / devicePixelRatioF();
    return imageFromWidget(position + QPointF(half, half));
}

bool ImageView::holds(const QPointF& image_px) const {
    const QSize image = imageSize();
    return frame_ && image_px.x() >= -0.5 && image_px.y() >= -0.5 && image_px.x() <= image.width() - 0.5 &&
           image_px.y() <= image.height() - 0.5;
}

void ImageView::keepInside() {
    const QSize image = imageSize();
    const auto keep = [this](double center, int pixels, int shown) {
        const double half = shown / 2.0 / scale();
        const double middle = (pixels - 1) / 2.0;
        const double room = std::max(0.0, pixels / 2.0 - half);
        return std::clamp(center, middle - room, middle + room);
    };
    center_px_ = {keep(center_px_.x(), image.width(), width()),
                  keep(center_px_.y(), image.height(), height())};
}

QSize ImageView::sizeHint() const { return {640, 360}; }

QSize ImageView::minimumSizeHint() const { return {160, 90}; }

void ImageView::resizeEvent(QResizeEvent*) { keepInside(); }

void ImageView::paintFrame(QPainter& painter) {
    const Visible visible = visiblePart(widgetFromImage(), size(), imageSize());
    const double ratio = devicePixelRatioF();
    const QSize device(std::max(1, qRound(visible.place.width() * ratio)),
                       std::max(1, qRound(visible.place.height() * ratio)));
    QImage pixels = raster_.render(shown_ ? shown_ : frame_, visible.part, device);
    pixels.setDevicePixelRatio(ratio);
    const QPointF at(qRound(visible.place.x() * ratio) / ratio, qRound(visible.place.y() * ratio) / ratio);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.drawImage(at, pixels);
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
}

void ImageView::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    const Theme& theme = currentTheme();
    const bool has_picture = frame_ && !frame_->image.empty();
    const QRectF shown =
        has_picture ? widgetFromImage().mapRect(QRectF(QPointF(-0.5, -0.5), QSizeF(imageSize()))) : QRectF();
    if (!shown.contains(event->rect())) {
        painter.fillRect(event->rect(), themeNamed(PaletteName::kNight).field);
    }
    if (has_picture) {
        paintFrame(painter);
        paintOverlay(painter, overlay_, widgetFromImage(), theme);
        paintTools(painter, tools_, widgetFromImage(), theme);
        if (paint_over_) {
            painter.save();
            paint_over_(painter, widgetFromImage());
            painter.restore();
        }
    }
    if (!caption_.isEmpty()) {
        paintPlate(painter, rect(), Qt::AlignLeft | Qt::AlignBottom, caption_, theme);
    }
    if (!notice_.isEmpty()) {
        paintPlate(painter, rect(), Qt::AlignHCenter | Qt::AlignVCenter, notice_, theme);
    }
    if (has_picture && frame_ != painted_) {
        painted_ = frame_;
        Q_EMIT framePainted(frame_);
    }
}

void ImageView::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / 120.0;
    zoomAbout(event->position(), zoom_ * std::pow(kWheelFactor, steps));
    event->accept();
}

bool ImageView::event(QEvent* event) {
    if (event->type() == QEvent::NativeGesture) {  // a touch pad
        const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
        if (gesture.gestureType() == Qt::ZoomNativeGesture) {
            zoomAbout(gesture.position(), zoom_ * (1.0 + gesture.value()));
            return true;
        }
    } else if (event->type() == QEvent::Gesture) {  // two fingers on the screen
        auto& gestures = static_cast<QGestureEvent&>(*event);
        if (const auto* const pinch = static_cast<QPinchGesture*>(gestures.gesture(Qt::PinchGesture))) {
            cancelDrag();  // the first finger was no press
            zoomAbout(mapFromGlobal(pinch->centerPoint()), zoom_ * pinch->scaleFactor());
            gestures.accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void ImageView::cancelDrag() {
    const bool was_tool = drag_ == DragUse::kTool;
    pressed_at_.reset();
    drag_.reset();
    if (was_tool) {
        Q_EMIT dragCancelled();
    }
}

void ImageView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        pressed_at_ = event->position();
        pressed_modifiers_ = event->modifiers();
        pressed_px_ = pixelUnderMouse(event->position());
        pressed_center_px_ = center_px_;
        drag_.reset();
    }
}

void ImageView::dragTo(const QMouseEvent& event) {
    const QPointF moved = event.position() - *pressed_at_;
    if (!drag_ && moved.manhattanLength() >= QApplication::startDragDistance()) {
        drag_ = drag_policy_ && holds(pressed_px_) ? drag_policy_(pressed_px_, pressed_modifiers_)
                                                   : DragUse::kPan;
        if (drag_ == DragUse::kPan && !isLargerThanWidget()) {
            drag_ = DragUse::kNone;
        }
    }
    if (drag_ == DragUse::kPan) {
        setCenter(pressed_center_px_ - moved / scale());
    } else if (drag_ == DragUse::kTool) {
        Q_EMIT dragMoved(pressed_px_, pixelUnderMouse(event.position()));
    }
}

void ImageView::mouseMoveEvent(QMouseEvent* event) {
    if (pressed_at_) {
        dragTo(*event);
    }
    const QPointF px = pixelUnderMouse(event->position());
    if (holds(px)) {
        Q_EMIT hovered(px);
    }
}

void ImageView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !pressed_at_) {
        return;
    }
    pressed_at_.reset();
    const DragUse use = std::exchange(drag_, std::nullopt).value_or(DragUse::kNone);
    const QPointF px = pixelUnderMouse(event->position());
    if (use == DragUse::kTool) {
        Q_EMIT dragEnded(pressed_px_, px);
    } else if (use == DragUse::kNone && holds(px)) {
        Q_EMIT pixelClicked(px, event->modifiers());
    }
}

void ImageView::mouseDoubleClickEvent(QMouseEvent* event) {
    const QPointF px = pixelUnderMouse(event->position());
    if (event->button() == Qt::LeftButton && holds(px)) {
        Q_EMIT pixelDoubleClicked(px, event->modifiers());
    }
}

void ImageView::leaveEvent(QEvent*) { Q_EMIT hoverEnded(); }

}  // namespace pmts::gui
