#include "timeline_view.hpp"

#include <QBuffer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSvgGenerator>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>

namespace pmts::gui {
namespace {

constexpr double kPick_px = 4.0;
constexpr double kZoomStep = 1.5;
constexpr double kPanPart = 0.2;
constexpr double kClosest_ns = 2e4;   ///< a pixel: a byte at 9600 baud is 50 pixels
constexpr double kFarthest_ns = 2e10;
constexpr double kRightAir_px = 12.0;
constexpr core::Duration kSeenWithin = std::chrono::seconds(1);
constexpr QSize kSaved_px(1600, 520);

core::Duration spanOf(double px, double ns_per_px) { return core::Duration(static_cast<core::Duration::rep>(px * ns_per_px)); }

double squaredOutside(const QRectF& place, const QPointF& at) {
    const double dx = std::max({place.left() - at.x(), 0.0, at.x() - place.right()});
    return dx * dx;
}

/// The lanes in which an event can be picked.
bool isIn(const app::LineEvent& event, Lane lane) {
    const bool is_transaction = event.kind == app::LineEvent::Kind::kTransaction;
    switch (lane) {
        case Lane::kPause: return is_transaction && event.record.video_paused;
        case Lane::kWait:
        case Lane::kAnswer: return is_transaction;
        default: return laneOf(event) == lane;
    }
}

}  // namespace

TimelineView::TimelineView(const app::Timeline& timeline, QWidget* parent) : QWidget(parent), timeline_(timeline) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Time line of the line"));
}

TimelineLayout TimelineView::layoutNow() const {
    TimelineLayout layout(size(), font(), from_, ns_per_px_);
    if (following_) {
        layout.from = timeline_.now() - spanOf(width() - layout.gutter() - kRightAir_px, ns_per_px_);
    }
    return layout;
}

core::Duration TimelineView::shownFrom() const { return layoutNow().from; }

core::Duration TimelineView::shownTo() const { return layoutNow().to(); }

void TimelineView::setFollowing(bool on) {
    if (on == following_) {
        return;
    }
    from_ = layoutNow().from;
    following_ = on;
    update();
    Q_EMIT followingChanged(on);
}

void TimelineView::moveTo(core::Duration from) {
    setFollowing(false);
    from_ = from;
    update();
}

void TimelineView::zoomBy(double factor) {
    const TimelineLayout layout = layoutNow();
    zoomAbout(following_ ? layout.x(timeline_.now()) : (layout.gutter() + width()) / 2, factor);
}

/// While the newest is followed the zoom holds on to it.
void TimelineView::zoomAbout(double x, double factor) {
    const core::Duration held = layoutNow().at(x);
    ns_per_px_ = std::clamp(ns_per_px_ / factor, kClosest_ns, kFarthest_ns);
    if (!following_) {
        from_ = held - spanOf(x - layoutNow().gutter(), ns_per_px_);
    }
    update();
}

void TimelineView::panBy(double part) {
    const TimelineLayout layout = layoutNow();
    moveTo(layout.from + spanOf((width() - layout.gutter()) * part, ns_per_px_));
}

void TimelineView::showAll() {
    const TimelineLayout layout = layoutNow();
    core::Duration first = timeline_.now() - std::chrono::seconds(1);
    if (!timeline_.events().empty()) {
        first = std::min(first, timeline_.events().front().began);
    }
    const double room = std::max(50.0, width() - layout.gutter() - 2 * kRightAir_px);
    ns_per_px_ = std::clamp(static_cast<double>((timeline_.now() - first).count()) / room, kClosest_ns, kFarthest_ns);
    moveTo(first - spanOf(kRightAir_px, ns_per_px_));
}

void TimelineView::choose(const std::optional<std::uint64_t>& number) {
    chosen_ = number;
    const app::LineEvent* const event = number ? timeline_.find(*number) : nullptr;
    if (event != nullptr) {
        const TimelineLayout layout = layoutNow();
        const double left = layout.x(event->sent);
        const double right = layout.x(event->ended);
        if (right < layout.gutter() + kRightAir_px || left > width() - kRightAir_px) {
            moveTo(event->sent - spanOf((width() - layout.gutter()) / 2, ns_per_px_));
        }
    }
    update();
}

/// Where a pixel is longer than the time since the last painting nothing has moved; what is new still shows within a second.
void TimelineView::tick() {
    const core::Duration since = timeline_.now() - painted_at_;
    const bool has_moved = since < core::Duration(0) || since >= std::min(spanOf(1.0, ns_per_px_), kSeenWithin);
    if (has_moved && (following_ || shownTo() > timeline_.now())) {
        update();
    }
}

const app::LineEvent* TimelineView::eventAt(const QPointF& at) const {
    const TimelineLayout layout = layoutNow();
    const app::LineEvent* nearest = nullptr;
    double nearest_px2 = kPick_px * kPick_px;
    for (std::size_t i = 0; i < kLaneCount; ++i) {
        const auto lane = static_cast<Lane>(i);
        if (!layout.lane(lane).contains(at) || at.x() < layout.gutter()) {
            continue;
        }
        const auto [first, last] = timeline_.eventsIn(layout.at(at.x() - kPick_px), layout.at(at.x() + kPick_px));
        for (std::size_t n = first; n < last; ++n) {
            const app::LineEvent& event = timeline_.events()[n];
            const core::Duration from = lane == Lane::kWait ? event.began : lane == Lane::kAnswer ? event.ended : event.sent;
            const core::Duration to = lane == Lane::kWait ? event.sent : event.ended;
            const QRectF place(QPointF(layout.x(from), at.y()), QPointF(layout.x(to), at.y()));
            const double away = squaredOutside(place, at);
            if (isIn(event, lane) && away <= nearest_px2) {
                nearest = &event;
                nearest_px2 = away;
            }
        }
    }
    return nearest;
}

bool TimelineView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {  // these would turn the instrument
        switch (static_cast<QKeyEvent*>(event)->key()) {
            case Qt::Key_Left:
            case Qt::Key_Right:
            case Qt::Key_Up:
            case Qt::Key_Down:
            case Qt::Key_Plus:
            case Qt::Key_Minus:
            case Qt::Key_0:
            case Qt::Key_Home:
            case Qt::Key_End: event->accept(); return true;
            default: break;
        }
    }
    return QWidget::event(event);
}

void TimelineView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left: return panBy(-kPanPart);
        case Qt::Key_Right: return panBy(kPanPart);
        case Qt::Key_Up:
        case Qt::Key_Plus: return zoomBy(kZoomStep);
        case Qt::Key_Down:
        case Qt::Key_Minus: return zoomBy(1 / kZoomStep);
        case Qt::Key_0: return showAll();
        case Qt::Key_Home:
            return moveTo(timeline_.events().empty() ? shownFrom() : timeline_.events().front().began);
        case Qt::Key_End: return setFollowing(true);
        default: QWidget::keyPressEvent(event);
    }
}

void TimelineView::wheelEvent(QWheelEvent* event) {
    zoomAbout(event->position().x(), wheelZoom(*event));
    event->accept();
}

void TimelineView::mousePressEvent(QMouseEvent* event) {
    drag_.press(event->position());
}

void TimelineView::mouseMoveEvent(QMouseEvent* event) {
    if (drag_.isPressed() && event->buttons()) {
        if (const QPointF moved = drag_.moved(event->position()); !moved.isNull()) {
            moveTo(layoutNow().from - spanOf(moved.x(), ns_per_px_));
        }
        return;
    }
    const app::LineEvent* const pointed = eventAt(event->position());
    const QString text = pointed ? timeline_.words().details(*pointed).join(u'\n') : QString();
    QToolTip::showText(event->globalPosition().toPoint(), text, this);
    Q_EMIT eventPointed(text);
}

void TimelineView::mouseReleaseEvent(QMouseEvent* event) {
    if (!drag_.release()) {
        return;
    }
    if (const app::LineEvent* const clicked = eventAt(event->position())) {
        choose(clicked->number);
        Q_EMIT eventChosen(clicked->number);
    }
}

void TimelineView::paintEvent(QPaintEvent*) {
    painted_at_ = timeline_.now();
    QPainter painter(this);
    paintTimeline(painter, timeline_, layoutNow(), currentTheme(), chosen_);
}

TimelineLayout TimelineView::savedLayout() const {
    TimelineLayout layout = layoutNow();
    layout.ns_per_px *= (width() - layout.gutter()) / (kSaved_px.width() - layout.gutter());
    layout.size = kSaved_px;
    return layout;
}

QImage TimelineView::picture() const {
    QImage picture(kSaved_px, QImage::Format_RGB32);
    QPainter painter(&picture);
    paintTimeline(painter, timeline_, savedLayout(), themeNamed(PaletteName::kSun), chosen_);
    return picture;
}

QByteArray TimelineView::drawing() const {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator drawing;
    drawing.setOutputDevice(&buffer);
    drawing.setSize(kSaved_px);
    drawing.setViewBox(QRect(QPoint(), kSaved_px));
    QPainter painter(&drawing);
    paintTimeline(painter, timeline_, savedLayout(), themeNamed(PaletteName::kSun), chosen_);
    painter.end();
    return bytes;
}

}  // namespace pmts::gui
