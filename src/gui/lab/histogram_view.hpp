#pragma once

#include "pmts/camera/picture_meters.hpp"

#include <QWidget>

namespace pmts::gui {

/// Brightness as a filled curve, red, green and blue as lines over it; the ends are marked where pixels pile up there.
/// Heights are square roots of the shares: a sky does not flatten the rest. Hover tells level and shares.
class HistogramView : public QWidget {
    Q_OBJECT
public:
    explicit HistogramView(QWidget* parent = nullptr);

    void showMeters(const camera::PictureMeters& meters);
    [[nodiscard]] QSize sizeHint() const override { return {300, 88}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 72}; }
    /// `level 255: brightness 2.1 %, red 2.3 %, green 2.0 %, blue 2.1 %`
    [[nodiscard]] QString textAt(const QPointF& at) const;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] QPolygonF line(const camera::Histogram& histogram, double highest) const;

    camera::PictureMeters meters_;
};

}  // namespace pmts::gui
