#pragma once

#include <QPointF>

#include <optional>

class QWheelEvent;

namespace pmts::gui {

/// A press that becomes a drag once it has moved far enough: what pans with the mouse shares this.
class PanDrag {
public:
    void press(const QPointF& at);
    /// How far the pointer has moved since it was asked last; zero while it may still become a click.
    [[nodiscard]] QPointF moved(const QPointF& at);
    /// True where it was a click.
    [[nodiscard]] bool release();
    [[nodiscard]] bool isPressed() const { return at_.has_value(); }

private:
    std::optional<QPointF> at_;
    bool is_drag_ = false;
};

/// How much nearer a turn of the wheel brings what is shown: a quarter for each click of it.
[[nodiscard]] double wheelZoom(const QWheelEvent& event);

}  // namespace pmts::gui
