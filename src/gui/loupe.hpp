#pragma once

#include "pmts/camera/frame.hpp"

#include <QPointF>
#include <QWidget>

#include <optional>

namespace pmts::gui {

/// Eight times the pixels around a place of a picture, with a cross on the place itself.
class Loupe : public QWidget {
    Q_OBJECT
public:
    static constexpr int kMagnification = 8;

    explicit Loupe(QWidget* parent = nullptr);

    void showAround(camera::FramePtr frame, const QPointF& image_px);
    /// The same place in a newer frame.
    void setFrame(camera::FramePtr frame);
    [[nodiscard]] std::optional<QPointF> place() const { return place_; }

    [[nodiscard]] QSize sizeHint() const override { return {200, 150}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {80, 60}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    camera::FramePtr frame_;
    std::optional<QPointF> place_;
};

}  // namespace pmts::gui
