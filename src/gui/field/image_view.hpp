#pragma once

#include "frame_raster.hpp"
#include "image_overlay.hpp"
#include "overlay_tools.hpp"
#include "pmts/camera/frame.hpp"

#include <QTransform>
#include <QWidget>

#include <functional>

namespace pmts::gui {

/// A picture to look at and to click: fits its widget, zooms 1x to 8x about the cursor by wheel or pinch,
/// pans by dragging. Every place it takes or tells is a pixel of the image, pixel centre of the top-left
/// pixel (0, 0).
class ImageView : public QWidget {
    Q_OBJECT
public:
    static constexpr double kLargestZoom = 8.0;
    enum class DragUse { kNone, kPan, kTool };
    /// What a drag that starts at this pixel is for.
    using DragPolicy = std::function<DragUse(const QPointF& image_px, Qt::KeyboardModifiers modifiers)>;

    explicit ImageView(QWidget* parent = nullptr);

    void setFrame(camera::FramePtr frame);
    [[nodiscard]] const camera::FramePtr& frame() const { return frame_; }
    /// Painted in the frame's place, pixel for pixel (a filter): clicks and frame() stay those of the frame. Until the next setFrame().
    void setShown(camera::FramePtr shown);
    void setOverlay(ImageOverlay overlay);
    [[nodiscard]] const ImageOverlay& overlay() const { return overlay_; }
    void setToolOverlay(const ToolOverlay& tools);
    [[nodiscard]] const ToolOverlay& toolOverlay() const { return tools_; }
    void setDragPolicy(DragPolicy policy) { drag_policy_ = std::move(policy); }
    /// Drawn after everything else of the picture.
    using PaintOver = std::function<void(QPainter& painter, const QTransform& widget_from_image)>;
    void setPaintOver(PaintOver paint) { paint_over_ = std::move(paint); }
    void cancelDrag();
    void setCaption(const QString& caption);  ///< plate at the lower left
    [[nodiscard]] QString caption() const { return caption_; }
    void setNotice(const QString& notice);  ///< plate in the middle: why there is no picture, or an old one

    [[nodiscard]] double zoom() const { return zoom_; }
    void setZoom(double zoom);  ///< about the centre of the view
    virtual void zoomAbout(const QPointF& widget_at, double zoom);
    [[nodiscard]] double scale() const;  ///< widget pixels per image pixel
    void fit() { setZoom(1.0); }

    [[nodiscard]] QPointF imageFromWidget(const QPointF& widget_at) const;
    [[nodiscard]] QPointF widgetFromImage(const QPointF& image_px) const;
    [[nodiscard]] QTransform widgetFromImage() const;
    /// The pixel under the middle of a mouse position; a 1:1 view tells whole numbers.
    [[nodiscard]] QPointF pixelUnderMouse(const QPointF& position) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void pixelClicked(const QPointF& image_px, Qt::KeyboardModifiers modifiers);
    void pixelDoubleClicked(const QPointF& image_px, Qt::KeyboardModifiers modifiers);
    void dragMoved(const QPointF& from_px, const QPointF& to_px);  ///< a drag that is a tool's
    void dragEnded(const QPointF& from_px, const QPointF& to_px);
    void dragCancelled();
    void hovered(const QPointF& image_px);
    void hoverEnded();
    void zoomChanged(double zoom);
    void framePainted(const pmts::camera::FramePtr& frame);  ///< once for each frame that reached the screen

protected:
    [[nodiscard]] virtual double unzoomedScale() const;  ///< widget pixels per image pixel at zoom 1
    [[nodiscard]] virtual std::pair<double, double> zoomLimits() const { return {1.0, kLargestZoom}; }
    virtual void keepInside();
    void setCenter(const QPointF& image_px);
    [[nodiscard]] QSize imageSize() const;
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] bool holds(const QPointF& image_px) const;
    [[nodiscard]] bool isLargerThanWidget() const;
    void dragTo(const QMouseEvent& event);
    void paintFrame(QPainter& painter);

    camera::FramePtr frame_;
    camera::FramePtr shown_;  ///< null: the frame itself
    camera::FramePtr painted_;
    FrameRaster raster_;
    ImageOverlay overlay_;
    QString caption_, notice_;
    double zoom_ = 1.0;
    QPointF center_px_;  ///< image pixel shown in the middle of the widget
    ToolOverlay tools_;
    DragPolicy drag_policy_;
    PaintOver paint_over_;
    std::optional<QPointF> pressed_at_;
    Qt::KeyboardModifiers pressed_modifiers_;
    QPointF pressed_px_, pressed_center_px_;
    std::optional<DragUse> drag_;  ///< once the mouse has gone far enough to be a drag
};

}  // namespace pmts::gui
