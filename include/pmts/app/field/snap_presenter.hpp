#pragma once

#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/desk/threading.hpp"
#include "pmts/targeting/snap.hpp"

#include <QObject>
#include <QPointF>
#include <QThreadPool>

#include <functional>
#include <optional>

namespace pmts::app {

using targeting::SnapKind;

/// The spot a click would take, pixels of the picture.
struct SnapSpot {
    SnapKind kind = SnapKind::kCorner;
    QPointF px;
    QPointF half_axes_px;         ///< of a circle or ellipse, the longer first; else 0
    double axis_angle_rad = 0.0;  ///< of the longer axis, clockwise from right
};

/// Lets a click jump to the corner, crossing, circle or ellipse beside it, and shows the spot before the click. Looking
/// is done on a thread of its own; only the newest place and the newest frame count, nothing queues up.
class SnapPresenter : public QObject {
    Q_OBJECT
public:
    SnapPresenter(LivePresenter& live, Preferences& preferences, Threading threading = Threading::kOwnThread,
                  QObject* parent = nullptr);
    ~SnapPresenter() override;  ///< waits for what is being looked at

    [[nodiscard]] bool isOn() const { return preferences_.settings().image_tools.snap; }
    /// Absent while snap is off, nothing is near, or the cursor is in the other picture.
    [[nodiscard]] std::optional<SnapSpot> spotIn(Picture picture) const;
    /// The cursor is here. Spots farther than `reach_px` do not count; in the live picture newer frames are followed.
    void look(Picture picture, const camera::FramePtr& frame, const QPointF& cursor_px, double reach_px);
    void lookAway();
    /// Calls `take` once with the spot beside a click, or with the click when nothing is near or snap is off: at once
    /// when the spot is drawn already, else when it has been looked for.
    void choose(Picture picture, const camera::FramePtr& frame, const QPointF& clicked_px, double reach_px,
                std::function<void(QPointF)> take);

public Q_SLOTS:
    void setOn(bool on);

Q_SIGNALS:
    void spotChanged();

private:
    struct Question {
        Picture picture = Picture::kLive;
        camera::FramePtr frame;
        QPointF at_px;
        double reach_px = 0.0;
        std::function<void(QPointF)> take;  ///< of a click
    };

    void ask(Question question);
    void start(Question question);
    void finish(const std::optional<SnapSpot>& spot);
    void followFrame();
    void show(const std::optional<SnapSpot>& spot);

    LivePresenter& live_;
    Preferences& preferences_;
    Threading threading_;
    std::optional<Question> asked_;    ///< where the cursor is
    std::optional<Question> running_;  ///< being looked at
    std::optional<Question> click_, hover_;  ///< next, the click first
    std::optional<Question> answered_;
    std::optional<SnapSpot> spot_;
    QThreadPool pool_;
};

}  // namespace pmts::app
