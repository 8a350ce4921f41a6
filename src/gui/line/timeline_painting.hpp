#pragma once

#include "pmts/app/line/timeline.hpp"
#include "pmts/gui/theme.hpp"

#include <QFont>
#include <QRectF>

#include <array>
#include <optional>

class QPainter;

namespace pmts::gui {

/// The lanes from top to bottom.
enum class Lane { kOwner, kWait, kPmts, kPanel, kAnswer, kUnasked, kPause, kPicture };
inline constexpr std::size_t kLaneCount = 8;

/// A span of the time line laid out on a rectangle: lane names at the left, the time of day on top.
struct TimelineLayout {
    TimelineLayout(const QSizeF& the_size, const QFont& the_font, core::Duration the_from, double the_ns_per_px);

    QSizeF size;
    QFont font;
    core::Duration from{0};
    double ns_per_px = 1e7;

    [[nodiscard]] double gutter() const { return gutter_px_; }  ///< width of the names
    [[nodiscard]] double axisHeight() const { return axis_px_; }
    [[nodiscard]] QRectF lane(Lane lane) const;
    [[nodiscard]] double x(core::Duration at) const;
    [[nodiscard]] core::Duration at(double x) const;
    [[nodiscard]] core::Duration to() const { return at(size.width()); }

private:
    // Measured once: a bar asks for its place several times, and a text takes microseconds to measure.
    double gutter_px_;
    double axis_px_;
};

[[nodiscard]] QString laneName(Lane lane);
/// Where an event's bar stands; a transaction has marks in other lanes too.
[[nodiscard]] Lane laneOf(const app::LineEvent& event);

/// Paints what the span shows and nothing else; what falls into one pixel is painted once, the worst of it.
/// `chosen`: the event with a frame around it.
void paintTimeline(QPainter& painter, const app::Timeline& timeline, const TimelineLayout& layout, const Theme& theme,
                   const std::optional<std::uint64_t>& chosen);

}  // namespace pmts::gui
