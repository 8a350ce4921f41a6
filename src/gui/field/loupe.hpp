#pragma once

#include "image_view.hpp"

namespace pmts::gui {

/// The pixels around a place of a picture, 2 to 16 times their size, with a cross on the place itself. The
/// wheel or a pinch changes the magnification; a click tells the pixel of the picture it shows, parts of a
/// pixel included.
class Loupe : public ImageView {
    Q_OBJECT
public:
    static constexpr double kLeast = 2.0;
    static constexpr double kMost = 16.0;

    explicit Loupe(QWidget* parent = nullptr);

    void showAround(camera::FramePtr frame, const QPointF& image_px);
    /// The same place in a newer frame; nothing before the first place.
    void follow(camera::FramePtr frame);
    /// What the picture's own view draws, without its reticle and curve.
    void showOverlay(const ImageOverlay& of_picture);
    [[nodiscard]] std::optional<QPointF> place() const { return place_; }

    void zoomAbout(const QPointF& widget_at, double zoom) override;
    [[nodiscard]] QSize sizeHint() const override { return {200, 150}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {80, 60}; }

protected:
    [[nodiscard]] double unzoomedScale() const override { return 1.0; }
    [[nodiscard]] std::pair<double, double> zoomLimits() const override { return {kLeast, kMost}; }
    void keepInside() override {}  // the place stays in the middle, also at the picture's edge

private:
    void showMagnification();

    std::optional<QPointF> place_;
};

}  // namespace pmts::gui
