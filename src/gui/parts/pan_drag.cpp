#include "pan_drag.hpp"

#include <QApplication>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace pmts::gui {

void PanDrag::press(const QPointF& at) {
    at_ = at;
    is_drag_ = false;
}

QPointF PanDrag::moved(const QPointF& at) {
    if (!at_) {
        return {};
    }
    const QPointF moved = at - *at_;
    is_drag_ = is_drag_ || moved.manhattanLength() >= QApplication::startDragDistance();
    if (!is_drag_) {
        return {};
    }
    at_ = at;
    return moved;
}

bool PanDrag::release() { return std::exchange(at_, std::nullopt).has_value() && !std::exchange(is_drag_, false); }

double wheelZoom(const QWheelEvent& event) {
    constexpr double kStep = 1.25;
    constexpr double kClick = 120.0;  ///< eighths of a degree
    return std::pow(kStep, event.angleDelta().y() / kClick);
}

}  // namespace pmts::gui
