#include "timeline_painting.hpp"

#include "parts/state_lamp.hpp"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pmts::gui {
namespace {

using app::LineEvent;
using app::LineHealth;

constexpr double kAir_px = 4.0;        ///< above and below the bars of a lane
constexpr core::Duration kWorthSeeing = std::chrono::milliseconds(1);  ///< of a wait: handing over takes microseconds
constexpr double kNeighbour_px = 4.0;
constexpr double kLeastText_px = 30.0;  ///< of a bar that may hold a text
constexpr double kLamp_px = 13.0;
constexpr double kLeastAnswer_px = 50.0;
constexpr double kReading_px = 260.0;  ///< of the text beside what came unasked
constexpr double kLeastTick_px = 95.0;  ///< between two times of day

QString say(const char* text) { return QCoreApplication::translate("Timeline", text); }

/// One painting: what the lanes share.
class Sheet {
public:
    Sheet(QPainter& painter, const app::Timeline& timeline, const TimelineLayout& layout, const Theme& theme)
        : painter_(painter), timeline_(timeline), layout_(layout), theme_(theme), metrics_(layout.font) {}

    void ground();
    void axis();
    void owners();
    void events(const std::optional<std::uint64_t>& chosen);
    void pictures();
    void names();

private:
    void event(const LineEvent& event);
    void wait(const LineEvent& event);
    void exchange(const LineEvent& event, Lane lane);
    void answer(const LineEvent& event);
    void sayAnswer(double until_px);
    void remark(const LineEvent& event);
    void missing(const LineEvent& event);
    void reading(const LineEvent& event, const QRectF& place);
    void frame(const LineEvent& event);
    void picture(const app::FrameTick& tick, double before_x);
    void bar(const QRectF& place, LineHealth health, const QColor& color);
    void lampAt(double x, Lane lane, LineHealth health);
    void textIn(const QRectF& place, const QString& text, const QColor& ink);
    [[nodiscard]] QRectF span(Lane lane, core::Duration from, core::Duration to) const;
    [[nodiscard]] bool isPainted(Lane lane, const QRectF& place, LineHealth health);

    QPainter& painter_;
    const app::Timeline& timeline_;
    const TimelineLayout& layout_;
    const Theme& theme_;
    QFontMetricsF metrics_;
    struct Last {
        double left_px = -1e9;
        double right_px = -1e9;
        LineHealth health = LineHealth::kGood;
    };
    std::array<Last, kLaneCount> last_;
    const LineEvent* unsaid_ = nullptr;  ///< the last answer, its words are not painted yet
    double unsaid_left_px_ = 0.0;
    double reading_end_ = -1e9;
};

QRectF Sheet::span(Lane lane, core::Duration from, core::Duration to) const {
    const QRectF row = layout_.lane(lane);
    const double left = std::max(layout_.x(from), layout_.gutter() - 2.0);
    const double right = std::min(layout_.x(to), layout_.size.width() + 2.0);
    const double wide = right - left > kNeighbour_px ? right - left - 1.0 : right - left;  // the next one may follow at once
    return {left, row.top() + kAir_px, std::max(wide, 1.5), row.height() - 2 * kAir_px};
}

/// Whether something as bad stands in this very pixel already.
bool Sheet::isPainted(Lane lane, const QRectF& place, LineHealth health) {
    Last& last = last_[static_cast<std::size_t>(lane)];
    if (place.left() >= last.left_px - 0.5 && place.right() <= last.right_px + 0.5 && health <= last.health) {
        return true;
    }
    last = {place.left(), place.right(), health};
    return false;
}

void Sheet::ground() {
    painter_.fillRect(QRectF({0, 0}, layout_.size), theme_.field);
    for (std::size_t i = 0; i < kLaneCount; i += 2) {
        painter_.fillRect(layout_.lane(static_cast<Lane>(i)), theme_.panel);
    }
}

void Sheet::axis() {
    static const double kSteps_s[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 120, 300, 600, 1800, 3600};
    const double wanted_s = kLeastTick_px * layout_.ns_per_px * 1e-9;
    const double step_s = *std::find_if(std::begin(kSteps_s), std::end(kSteps_s) - 1, [&](double step) { return step >= wanted_s; });
    const auto step_ms = static_cast<qint64>(std::max(1.0, step_s * 1e3));
    const qint64 zero_ms = timeline_.utcOf({}).toMSecsSinceEpoch();
    const qint64 left_ms = timeline_.utcOf(layout_.at(layout_.gutter())).toMSecsSinceEpoch();
    painter_.setFont(layout_.font);
    for (qint64 ms = (left_ms / step_ms + 1) * step_ms;; ms += step_ms) {
        const double x = layout_.x(std::chrono::milliseconds(ms - zero_ms));
        if (x > layout_.size.width()) {
            break;
        }
        painter_.setPen(QPen(theme_.border, 1.0, Qt::DotLine));
        painter_.drawLine(QPointF(x, layout_.axisHeight() - 4), QPointF(x, layout_.size.height()));
        const QString text = QDateTime::fromMSecsSinceEpoch(ms).toString(step_ms >= 1000 ? QStringLiteral("HH:mm:ss")
                                                                                         : QStringLiteral("HH:mm:ss.zzz"));
        painter_.setPen(theme_.text);
        painter_.drawText(QPointF(x + 3, layout_.axisHeight() - 6), text);
    }
    const double now_x = layout_.x(timeline_.now());
    if (now_x < layout_.size.width() && now_x > layout_.gutter()) {
        painter_.setPen(QPen(theme_.text, 1.5 * theme_.line_px));
        painter_.drawLine(QPointF(now_x, layout_.axisHeight()), QPointF(now_x, layout_.size.height()));
    }
}

void Sheet::textIn(const QRectF& place, const QString& text, const QColor& ink) {
    if (place.width() > kLeastText_px && metrics_.horizontalAdvance(text) + 8 <= place.width()) {
        painter_.setPen(ink);
        painter_.drawText(place.adjusted(4, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
    }
}

/// The computer's turns are full, the panel's hatched.
void Sheet::owners() {
    const auto& owners = timeline_.owners();
    const auto later = [](core::Duration at, const app::OwnerMark& mark) { return at < mark.from; };
    auto mark = std::upper_bound(owners.begin(), owners.end(), layout_.at(layout_.gutter()), later);
    if (mark != owners.begin()) {
        --mark;
    }
    for (; mark != owners.end() && mark->from < layout_.to(); ++mark) {
        const auto next = std::next(mark);
        const core::Duration until = next == owners.end() ? timeline_.now() : next->from;
        const QRectF place = span(Lane::kOwner, mark->from, until);
        if (mark->owner == scheduler::LineOwner::kIdle || place.right() < layout_.gutter() ||
            isPainted(Lane::kOwner, place, LineHealth::kGood)) {
            continue;
        }
        const bool is_panel = mark->owner == scheduler::LineOwner::kPanel;
        painter_.fillRect(place, is_panel ? QBrush(theme_.text, Qt::BDiagPattern) : QBrush(theme_.busy));
        if (!is_panel) {
            textIn(place, say("PMTS"), theme_.on_accent);
        }
    }
}

void Sheet::events(const std::optional<std::uint64_t>& chosen) {
    const auto [first, last] = timeline_.eventsIn(layout_.at(layout_.gutter()), layout_.to());
    const LineEvent* framed = nullptr;
    for (std::size_t i = first; i < last; ++i) {
        const LineEvent& now = timeline_.events()[i];
        if (now.began > layout_.to()) {
            continue;
        }
        event(now);
        framed = chosen == now.number ? &now : framed;
    }
    sayAnswer(layout_.size.width());
    if (framed != nullptr) {
        frame(*framed);
    }
}

void Sheet::event(const LineEvent& event) {
    if (event.kind != LineEvent::Kind::kTransaction) {
        return remark(event);
    }
    wait(event);
    exchange(event, laneOf(event));
    answer(event);
    if (event.record.video_paused) {
        const QRectF place = span(Lane::kPause, event.sent, event.ended);
        if (!isPainted(Lane::kPause, place, LineHealth::kGood)) {
            painter_.fillRect(place, QBrush(theme_.text, Qt::Dense5Pattern));
        }
    }
}

void Sheet::wait(const LineEvent& event) {
    const QRectF place = span(Lane::kWait, event.began, event.sent);
    if (event.waited() >= kWorthSeeing && !isPainted(Lane::kWait, place, LineHealth::kGood)) {
        painter_.fillRect(place.adjusted(0, place.height() / 4, 0, -place.height() / 4), theme_.idle);
    }
}

void Sheet::exchange(const LineEvent& event, Lane lane) {
    const QRectF place = span(lane, event.sent, event.ended);
    if (isPainted(lane, place, event.health)) {
        return;
    }
    bar(place, event.health, theme_.busy);
    lampAt(place.left(), lane, event.health);
    const double room = event.health >= LineHealth::kSlow ? kLamp_px : 0.0;
    const bool is_hollow = event.health == LineHealth::kNote || event.health == LineHealth::kSlow;
    if (place.width() - room > kLeastText_px) {
        textIn(place.adjusted(room, 0, 0, 0), timeline_.words().what(event), is_hollow ? theme_.text : theme_.on_accent);
    }
}

/// Good: full. Meant to be so: hollow. Slow: hollow and hatched. Failed: full, with its own sign.
void Sheet::bar(const QRectF& place, LineHealth health, const QColor& color) {
    switch (health) {
        case LineHealth::kGood: painter_.fillRect(place, color); return;
        case LineHealth::kFailed:
            painter_.fillRect(place, theme_.failed);
            return;
        case LineHealth::kSlow:
            painter_.fillRect(place, theme_.field);
            painter_.fillRect(place, QBrush(theme_.warning, Qt::FDiagPattern));
            break;
        case LineHealth::kNote: painter_.fillRect(place, theme_.field); break;
    }
    painter_.setPen(QPen(health == LineHealth::kSlow ? theme_.warning : theme_.text, theme_.line_px));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(place);
}

void Sheet::lampAt(double x, Lane lane, LineHealth health) {
    if (health < LineHealth::kSlow) {
        return;
    }
    const QRectF row = layout_.lane(lane);
    const QRectF place(x - 1, row.center().y() - kLamp_px / 2, kLamp_px, kLamp_px);
    painter_.fillRect(place.adjusted(-1, -1, 1, 1), theme_.field);
    paintLamp(painter_, place, health == LineHealth::kSlow ? app::DeviceState::kWarning : app::DeviceState::kFailed, theme_);
}

void Sheet::answer(const LineEvent& event) {
    if (event.health == LineHealth::kNote) {
        return;  // swallowed, cancelled, or silent as it may be: there was none
    }
    const QRectF place = span(Lane::kAnswer, event.ended, event.ended);
    if (place.left() < layout_.gutter() || isPainted(Lane::kAnswer, place, event.health)) {
        return;
    }
    painter_.fillRect(place.adjusted(0, 0, 0.5, 0), event.health == LineHealth::kFailed ? theme_.failed : theme_.good);
    lampAt(place.left(), Lane::kAnswer, event.health);
    sayAnswer(place.left());
    unsaid_ = &event;
    unsaid_left_px_ = place.right() + 4 + (event.health >= LineHealth::kSlow ? kLamp_px : 0.0);
}

/// The last answer in words, as far as the next one leaves room.
void Sheet::sayAnswer(double until_px) {
    const LineEvent* const event = std::exchange(unsaid_, nullptr);
    const double room = until_px - unsaid_left_px_ - 4;
    if (event != nullptr && room > kLeastAnswer_px) {
        const QRectF row = layout_.lane(Lane::kAnswer);
        painter_.setPen(theme_.text);
        painter_.drawText(QRectF(unsaid_left_px_, row.top(), room, row.height()), Qt::AlignLeft | Qt::AlignVCenter,
                          metrics_.elidedText(timeline_.words().answer(*event), Qt::ElideRight, room));
    }
}

void Sheet::remark(const LineEvent& event) {
    const Lane lane = laneOf(event);
    const QRectF place = span(lane, event.sent, event.ended);
    if (place.right() < layout_.gutter() || isPainted(lane, place, event.health)) {
        return;
    }
    switch (event.kind) {
        case LineEvent::Kind::kGap: bar(place, LineHealth::kSlow, theme_.busy); break;
        case LineEvent::Kind::kMissing: missing(event); break;
        case LineEvent::Kind::kStream:  // a thin bar below its reading: what runs anyway must not shout
            painter_.fillRect(place.adjusted(0, place.height() * 0.7, 0, 0), theme_.idle);
            break;
        case LineEvent::Kind::kUnasked: painter_.fillRect(place.adjusted(0, 0, 0.5, 0), theme_.good); break;
        default: painter_.fillRect(place, theme_.text); break;
    }
    lampAt(place.left(), lane, event.health);
    if (lane == Lane::kUnasked) {
        reading(event, place);
    }
}

/// Through all lanes: of nothing there is it known what happened.
void Sheet::missing(const LineEvent& event) {
    const double left = std::max(layout_.x(event.sent), layout_.gutter());
    const double wide = std::max(layout_.x(event.ended) - left, kNeighbour_px);
    painter_.fillRect(QRectF(left, layout_.axisHeight(), wide, layout_.size.height() - layout_.axisHeight()),
                      QBrush(theme_.warning, Qt::DiagCrossPattern));
}

/// What came, where the one before leaves room.
void Sheet::reading(const LineEvent& event, const QRectF& place) {
    const bool is_stream = event.kind == LineEvent::Kind::kStream;
    const double left = is_stream ? std::max(place.left(), layout_.gutter() + 3) : place.right() + 4 + (event.health >= LineHealth::kSlow ? kLamp_px : 0.0);
    const double room = layout_.size.width() - left;
    if (left < reading_end_ || room < 50) {
        return;
    }
    const bool is_trouble = !is_stream && event.stray != scheduler::StrayKind::kUnsolicited;
    const auto& words = timeline_.words();
    const QString text = metrics_.elidedText(is_trouble ? words.what(event) : words.answer(event), Qt::ElideRight, kReading_px);
    if (is_stream && metrics_.horizontalAdvance(text) > room) {
        return;  // the next picture has room for it
    }
    painter_.setPen(theme_.text);
    painter_.drawText(QRectF(left, place.top() - (is_stream ? kAir_px : 0.0), room, is_stream ? place.height() * 0.7 : place.height()),
                      Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, text);
    reading_end_ = left + metrics_.horizontalAdvance(text) + 8;
}

void Sheet::frame(const LineEvent& event) {
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(theme_.text, 2.0 * theme_.line_px));
    painter_.drawRect(span(laneOf(event), event.sent, event.ended).adjusted(-2, -2, 2, 2));
}

void Sheet::pictures() {
    const auto& frames = timeline_.frames();
    const auto earlier = [](const app::FrameTick& tick, core::Duration at) { return tick.at < at; };
    auto tick = std::lower_bound(frames.begin(), frames.end(), layout_.at(layout_.gutter()), earlier);
    double before_x = tick == frames.begin() ? layout_.gutter() : layout_.x(std::prev(tick)->at);
    for (; tick != frames.end() && tick->at < layout_.to(); ++tick) {
        picture(*tick, before_x);
        before_x = layout_.x(tick->at);
    }
}

/// A stroke where a picture came, a cross where some were dropped or are missing.
void Sheet::picture(const app::FrameTick& tick, double before_x) {
    const QRectF place = span(Lane::kPicture, tick.at, tick.at);
    const bool is_lost = tick.dropped + tick.missing > 0;
    if (isPainted(Lane::kPicture, place, is_lost ? LineHealth::kSlow : LineHealth::kGood)) {
        return;
    }
    painter_.fillRect(place.adjusted(0, place.height() * 0.45, -0.3, 0), theme_.text);
    if (is_lost) {
        const QPointF middle((before_x + place.left()) / 2, place.top() + place.height() * 0.22);
        painter_.setPen(QPen(tick.missing > 0 ? theme_.failed : theme_.text, 1.4 * theme_.line_px));
        painter_.drawLine(middle - QPointF(3, 3), middle + QPointF(3, 3));
        painter_.drawLine(middle - QPointF(3, -3), middle + QPointF(3, -3));
    }
}

void Sheet::names() {
    painter_.fillRect(QRectF(0, 0, layout_.gutter(), layout_.size.height()), theme_.panel);
    painter_.setPen(theme_.text);
    for (std::size_t i = 0; i < kLaneCount; ++i) {
        const QRectF row = layout_.lane(static_cast<Lane>(i));
        painter_.drawText(QRectF(6, row.top(), layout_.gutter() - 8, row.height()), Qt::AlignLeft | Qt::AlignVCenter,
                          laneName(static_cast<Lane>(i)));
    }
    painter_.setPen(QPen(theme_.border, theme_.line_px));
    painter_.drawLine(QPointF(layout_.gutter(), 0), QPointF(layout_.gutter(), layout_.size.height()));
    painter_.drawLine(QPointF(0, layout_.axisHeight()), QPointF(layout_.size.width(), layout_.axisHeight()));
}

}  // namespace

QString laneName(Lane lane) {
    switch (lane) {
        case Lane::kOwner: return say("Control");
        case Lane::kWait: return say("Waiting");
        case Lane::kPmts: return say("PMTS");
        case Lane::kPanel: return say("Panel");
        case Lane::kAnswer: return say("Answers");
        case Lane::kUnasked: return say("Unasked");
        case Lane::kPause: return say("Video pauses");
        case Lane::kPicture: return say("Pictures");
    }
    return {};
}

Lane laneOf(const LineEvent& event) {
    switch (event.kind) {
        case LineEvent::Kind::kTransaction: return event.record.master == scheduler::Master::kPanel ? Lane::kPanel : Lane::kPmts;
        case LineEvent::Kind::kGap: return Lane::kPicture;
        case LineEvent::Kind::kUnasked:
        case LineEvent::Kind::kStream:
        case LineEvent::Kind::kAir: return Lane::kUnasked;
        case LineEvent::Kind::kControl:
        case LineEvent::Kind::kConnection:
        case LineEvent::Kind::kMissing: return Lane::kOwner;
    }
    return Lane::kOwner;
}

TimelineLayout::TimelineLayout(const QSizeF& the_size, const QFont& the_font, core::Duration the_from, double the_ns_per_px)
    : size(the_size), font(the_font), from(the_from), ns_per_px(the_ns_per_px),
      gutter_px_(QFontMetricsF(font).horizontalAdvance(laneName(Lane::kPause)) + 16.0),
      axis_px_(QFontMetricsF(font).height() + 8.0) {}

QRectF TimelineLayout::lane(Lane lane) const {
    const double height = (size.height() - axisHeight()) / static_cast<double>(kLaneCount);
    return {0, axisHeight() + height * static_cast<double>(lane), size.width(), height};
}

double TimelineLayout::x(core::Duration at) const { return gutter() + static_cast<double>((at - from).count()) / ns_per_px; }

core::Duration TimelineLayout::at(double x) const {
    return from + core::Duration(static_cast<core::Duration::rep>((x - gutter()) * ns_per_px));
}

void paintTimeline(QPainter& painter, const app::Timeline& timeline, const TimelineLayout& layout, const Theme& theme,
                   const std::optional<std::uint64_t>& chosen) {
    painter.setFont(layout.font);
    Sheet sheet(painter, timeline, layout, theme);
    sheet.ground();
    sheet.axis();
    sheet.owners();
    sheet.pictures();
    sheet.events(chosen);
    sheet.names();
}

}  // namespace pmts::gui
