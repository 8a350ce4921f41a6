#pragma once

#include "parts/pan_drag.hpp"
#include "timeline_painting.hpp"

#include <QImage>
#include <QWidget>

namespace pmts::gui {

/// The lanes of the line over time. The wheel zooms about the pointer, dragging and Left / Right pan, Up / Down or + / -
/// zoom, Home goes to the oldest, End to now. Hover says what a bar is, a click chooses it.
class TimelineView : public QWidget {
    Q_OBJECT
public:
    explicit TimelineView(const app::Timeline& timeline, QWidget* parent = nullptr);

    /// The newest stays at the right edge; off: the picture stands still.
    void setFollowing(bool on);
    [[nodiscard]] bool isFollowing() const { return following_; }
    void zoomBy(double factor);  ///< > 1: more detail
    void panBy(double part);     ///< of the width, to the right is later
    void showAll();
    void choose(const std::optional<std::uint64_t>& number);  ///< brings it into sight
    [[nodiscard]] const std::optional<std::uint64_t>& chosen() const { return chosen_; }
    /// Repaints where something may have changed; a few times a second.
    void tick();

    [[nodiscard]] core::Duration shownFrom() const;
    [[nodiscard]] core::Duration shownTo() const;
    [[nodiscard]] TimelineLayout layoutNow() const;
    [[nodiscard]] const app::LineEvent* eventAt(const QPointF& at) const;
    /// What is shown, black on white.
    [[nodiscard]] QImage picture() const;
    [[nodiscard]] QByteArray drawing() const;  ///< SVG

    [[nodiscard]] QSize sizeHint() const override { return {800, 260}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 180}; }

Q_SIGNALS:
    void followingChanged(bool on);
    void eventChosen(quint64 number);
    void eventPointed(const QString& text);  ///< under the pointer; empty: nothing

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void zoomAbout(double x, double factor);
    void moveTo(core::Duration from);
    [[nodiscard]] TimelineLayout savedLayout() const;

    const app::Timeline& timeline_;
    core::Duration from_{0};
    double ns_per_px_ = 1.2e7;  ///< 10 s on 800 pixels
    bool following_ = true;
    core::Duration painted_at_{-1};
    std::optional<std::uint64_t> chosen_;
    PanDrag drag_;
};

}  // namespace pmts::gui
