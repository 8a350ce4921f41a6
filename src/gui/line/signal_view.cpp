#include "signal_view.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <array>

namespace pmts::gui {
namespace {

constexpr double kKeyStep = 2.0;
constexpr double kMostPixelsPerSample = 40.0;
constexpr double kRoomAround = 3.0;  ///< a selection takes a third of the width
constexpr double kLeastShare = 8.0;  ///< one that takes less than an eighth is brought nearer

}  // namespace

SignalView::SignalView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Signal and characters along the time"));
    setToolTip(tr("Wheel or + and - zoom, drag or arrows move, Home shows everything, a click chooses a line"));
}

void SignalView::showFindings(std::shared_ptr<const app::LineFindings> findings) {
    const bool other = !findings_ || !findings || findings_->recording != findings->recording;
    findings_ = std::move(findings);
    if (other) {
        selected_.reset();
        fit();
    }
    update();
}

double SignalView::samples() const {
    return findings_ ? std::max(1.0, static_cast<double>(findings_->samples())) : 1.0;
}

void SignalView::fit() {
    first_ = 0.0;
    per_px_ = samples() / std::max(1, width());
    is_fitted_ = true;
    update();
}

void SignalView::select(std::uint64_t from, std::uint64_t to) {
    selected_ = {from, to};
    const double length = static_cast<double>(to - from);
    const bool visible = sampleAt(0) <= static_cast<double>(from) && static_cast<double>(to) <= sampleAt(width()) &&
                         length / per_px_ > width() / kLeastShare;
    if (!visible) {
        per_px_ = kRoomAround * length / std::max(1, width());
        first_ = static_cast<double>(from) - length * (kRoomAround - 1.0) / 2.0;
        is_fitted_ = false;
        keepInside();
    }
    update();
}

void SignalView::zoomBy(double factor) { zoomAbout(width() / 2.0, factor); }

void SignalView::pan(double share) {
    first_ += share * width() * per_px_;
    keepInside();
    update();
}

void SignalView::zoomAbout(double x, double factor) {
    const double kept = sampleAt(x);
    per_px_ /= factor;
    keepInside();
    first_ = kept - x * per_px_;
    keepInside();
    update();
}

void SignalView::keepInside() {
    const double most = samples() / std::max(1, width());
    is_fitted_ = per_px_ >= most;
    per_px_ = std::clamp(per_px_, std::min(most, 1.0 / kMostPixelsPerSample), most);
    first_ = std::clamp(first_, 0.0, std::max(0.0, samples() - width() * per_px_));
}

bool SignalView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<QKeyEvent&>(*event);
        constexpr std::array kOwn{Qt::Key_Left, Qt::Key_Right, Qt::Key_Plus, Qt::Key_Minus, Qt::Key_Home};
        if (std::ranges::find(kOwn, key.key()) != kOwn.end() && !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier))) {
            event->accept();  // the arrows turn the instrument elsewhere
            return true;
        }
    }
    return QWidget::event(event);
}

void SignalView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left:
            return pan(-0.25);
        case Qt::Key_Right:
            return pan(0.25);
        case Qt::Key_Plus:
            return zoomBy(kKeyStep);
        case Qt::Key_Minus:
            return zoomBy(1.0 / kKeyStep);
        case Qt::Key_Home:
            return fit();
        default:
            QWidget::keyPressEvent(event);
    }
}

void SignalView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (is_fitted_) {
        fit();
    } else {
        keepInside();
    }
}

void SignalView::wheelEvent(QWheelEvent* event) {
    zoomAbout(event->position().x(), wheelZoom(*event));
    event->accept();
}

void SignalView::mousePressEvent(QMouseEvent* event) {
    drag_.press(event->position());
}

void SignalView::mouseMoveEvent(QMouseEvent* event) {
    if (const QPointF moved = drag_.moved(event->position()); !moved.isNull()) {
        first_ -= moved.x() * per_px_;
        keepInside();
        update();
    }
}

void SignalView::mouseReleaseEvent(QMouseEvent* event) {
    if (drag_.release() && findings_) {
        Q_EMIT sampleClicked(static_cast<std::uint64_t>(std::max(0.0, sampleAt(event->position().x()))));
    }
}

}  // namespace pmts::gui
