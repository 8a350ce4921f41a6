#pragma once

#include "image_view.hpp"
#include "picture_tools.hpp"
#include "pmts/app/desk/workbench.hpp"

namespace pmts::gui {

class PictureCallout;

/// What mouse and fingers do in one view of a picture: aim, turn, snap, choose a drawn point, drag, box,
/// mark.
class PictureInput : public QObject {
    Q_OBJECT
public:
    static constexpr double kPointReach = 12.0;  ///< widget pixels around a drawn point that choose it
    static constexpr double kSnapReach = 20.0;   ///< widget pixels, at most 15 of the picture
    static constexpr double kStick = 15.0;       ///< widget pixels around the reticle that hold a drag

    PictureInput(ImageView& view, app::Picture picture, app::Workbench& bench, PictureTools& tools);

    /// For views that show now one picture, now the other.
    void setPicture(app::Picture picture);
    /// Asked before a click aims; true when it was somebody's.
    void setFirstUse(std::function<bool(const QPointF& px)> use) { first_use_ = std::move(use); }

Q_SIGNALS:
    void pointChosen(qint64 row_id);    ///< a recorded point
    void plannedChosen(qint64 row_id);  ///< a planned point

private:
    void click(const QPointF& px, Qt::KeyboardModifiers modifiers);
    void doubleClick(const QPointF& px, Qt::KeyboardModifiers modifiers);
    void hover(const QPointF& px);
    void showSnap();
    void aim(const QPointF& px, bool only);  ///< only: never turns, whatever the setting says
    void turn(const QPointF& px);
    void turnTo(app::OverlayKind kind, qint64 row_id);
    void choosePoint(const ImageOverlay::Point& point);
    void chooseMark(const ImageOverlay::Point& mark);
    void drawMark(const QPointF& px);
    void dragMoved(const QPointF& from_px, const QPointF& to_px);
    void dragEnded(const QPointF& from_px, const QPointF& to_px);
    void clearDrag();
    void report(const core::Error& error);
    [[nodiscard]] ImageView::DragUse useOfDrag(const QPointF& px, Qt::KeyboardModifiers modifiers) const;
    [[nodiscard]] const ImageOverlay::Point* pointAt(const QPointF& px) const;
    [[nodiscard]] bool sticks(const QPointF& to_px) const;
    [[nodiscard]] double reach_px() const;

    ImageView& view_;
    app::Picture picture_;
    app::Workbench& bench_;
    PictureTools& tools_;
    PictureCallout* callout_;
    std::function<bool(const QPointF& px)> first_use_;
    qint64 grabbed_mark_ = 0;
};

}  // namespace pmts::gui
