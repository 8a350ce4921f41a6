#pragma once

#include "pmts/app/desk/instrument_desk.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/field/points_model.hpp"
#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/field/range_keeper.hpp"
#include "pmts/targeting/patch_ahead.hpp"
#include "pmts/survey/planned_point.hpp"

#include <QObject>
#include <QPointF>

#include <optional>

namespace pmts::app {

enum class Direction { kLeft, kRight, kUp, kDown };

/// A target before, during and after the move.
struct Target {
    targeting::Method method = targeting::Method::kRigorous;  ///< that computed a click
    std::optional<targeting::Click> click;      ///< where it was clicked, when it was: it can be found again
    std::optional<targeting::Recentred> proof;  ///< how well the telescope was put on it by the picture
    geometry::Pointing pointing;
    RangeAssumption range;
    QString name;     ///< `clicked`, `point 104`, `typed`, `5' left`
    QString ha_text, va_text, range_text;
    MoveState state = MoveState::kAimed;
    QString sentence;  ///< `Turning to 177.5612 gon, 96.1684 gon (40 %).`
};

/// From a click to a telescope that points there. Nothing turns before move(), moveTo…() or nudge() is called.
class TargetingPresenter : public QObject {
    Q_OBJECT
public:
    TargetingPresenter(InstrumentDesk& instrument, LivePresenter& live, const PointsModel& points,
                       const StationPresenter& station, RangeKeeper& range, Preferences& preferences,
                       MessageCentre& messages, QObject* parent = nullptr);

    [[nodiscard]] const std::optional<Target>& target() const { return target_; }
    [[nodiscard]] bool isMoving() const;
    [[nodiscard]] QString stepText() const;  ///< `5'`

public Q_SLOTS:
    void aimAtStillPixel(const QPointF& still_px);  ///< pixel of the still, not of the widget
    void aimAtLivePixel(const QPointF& frame_px);   ///< pixel of the frame shown now
    void aimAtPoint(qint64 row_id);
    void aimAtText(const QString& ha_text, const QString& va_text);
    void move();
    void moveToStillPixel(const QPointF& still_px);
    /// Aim and move in one: the double-click, and the refining click after an arrival.
    void moveToLivePixel(const QPointF& frame_px);
    void moveToPoint(qint64 row_id);
    /// The plain move, for a spot that the picture cannot find again.
    void moveWithoutPicture();
    /// The other way round, which unwinds the cable.
    void moveTheLongWay();
    void setRecentring(bool on);
    void setClickTurns(bool on);
    /// A plain click: aims, and turns at once when the setting says so.
    void clickLivePixel(const QPointF& frame_px);
    void clickStillPixel(const QPointF& still_px);
    /// To a place nobody has measured; the telescope aims at a mark of the present target height above it.
    void moveToPlanned(const pmts::survey::PlannedPoint& point);
    /// A point, planned point or mark that is drawn over the pictures.
    void moveToPlace(pmts::app::OverlayKind kind, qint64 row_id);
    /// What the live picture shows at `grabbed_px` comes to where it was released: a drag.
    void bringToPixel(const QPointF& grabbed_px, const QPointF& released_px);
    /// Circle readings somebody computed, for the range in use.
    void moveTo(const pmts::geometry::Pointing& pointing, const QString& name);
    /// The same target in the other face.
    void changeFace();
    void nudge(pmts::app::Direction direction);
    /// `5'`, `0.1 gon`, `2*30"`; a bare number has the current unit. Refused with stepRejected().
    void setStepText(const QString& text);
    void clearTarget();
    void stop();

Q_SIGNALS:
    void targetChanged();  ///< take target()
    void movingChanged(bool moving);
    void stepChanged(const QString& text);
    void aimingChanged();  ///< method, re-centring, tolerance, guard
    void stepRejected(const pmts::core::Error& error);

private:
    void aim(const QPointF& px, const geometry::Pointing& at, const camera::FramePtr& frame);
    void startMove(bool with_picture);
    [[nodiscard]] bool isAimedAtLive(const QPointF& frame_px) const;
    void aimAtPlace(const Eigen::Vector3d& p_station, RangeSource source, const QString& name);
    void setTarget(const geometry::Pointing& pointing, const RangeAssumption& range, const QString& name);
    void setState(MoveState state, const QString& sentence);
    void onTurned(Ticket ticket, const geometry::Pointing& arrived);
    void onStep(Ticket ticket, const targeting::RecentringStep& step);
    void onRecentred(Ticket ticket, const targeting::Recentred& proof);
    void arrive(const QString& sentence);
    void onSun(const QString& happened, const QString& remedy);
    void refreshGuard();
    [[nodiscard]] MessageAction wayOut(const core::Error& error) const;
    [[nodiscard]] QString residualText(const targeting::Recentred& proof) const;
    void onFailed(Ticket ticket, const core::Error& error);
    void onProgress(const instrument::Progress& progress);
    void refreshTexts();
    void abandonMove();
    void moveIfAimed();
    [[nodiscard]] std::optional<geometry::Pointing> startOfStep();

    InstrumentDesk& instrument_;
    LivePresenter& live_;
    const PointsModel& points_;
    const StationPresenter& station_;
    RangeKeeper& range_;
    Preferences& preferences_;
    MessageCentre& messages_;
    std::optional<Target> target_;
    Ticket ticket_ = 0;
    targeting::PatchAhead ahead_;
    std::vector<geometry::Pointing> legs_;  ///< still to go before the move itself, the next one last
};

}  // namespace pmts::app
