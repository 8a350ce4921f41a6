#include "pmts/app/field/targeting_presenter.hpp"

#include "desk/message_topics.hpp"
#include "pmts/geometry/polar.hpp"
#include "pmts/targeting/bring_pixel.hpp"
#include "pmts/targeting/click_method.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::app {

namespace {

constexpr double kUsualStepLimitGon = 100.0;
const QString kSunTopic = QStringLiteral("sun");

core::Error noReadings() {
    return {.kind = core::ErrorKind::kNotConnected,
            .happened = TargetingPresenter::tr("There are no circle readings for this picture."),
            .remedy = TargetingPresenter::tr("Connect the instrument, then click again."),
            .info_code = std::nullopt,
            .detail = {}};
}

}  // namespace

TargetingPresenter::TargetingPresenter(InstrumentDesk& instrument, LivePresenter& live, const PointsModel& points,
                                       const StationPresenter& station, RangeKeeper& range, Preferences& preferences,
                                       MessageCentre& messages, QObject* parent)
    : QObject(parent), instrument_(instrument), live_(live), points_(points), station_(station), range_(range),
      preferences_(preferences), messages_(messages) {
    connect(&instrument_, &InstrumentDesk::turned, this, &TargetingPresenter::onTurned);
    connect(&instrument_, &InstrumentDesk::requestFailed, this, &TargetingPresenter::onFailed);
    connect(&instrument_, &InstrumentDesk::progressChanged, this, &TargetingPresenter::onProgress);
    connect(&preferences_, &Preferences::unitsChanged, this, &TargetingPresenter::refreshTexts);
    connect(&instrument_, &InstrumentDesk::recentringStepped, this, &TargetingPresenter::onStep);
    connect(&instrument_, &InstrumentDesk::recentred, this, &TargetingPresenter::onRecentred);
    connect(&instrument_, &InstrumentDesk::sunCame, this, &TargetingPresenter::onSun);
    connect(&preferences_, &Preferences::changed, this, &TargetingPresenter::refreshGuard);
    connect(&station_, &StationPresenter::stationChanged, this, &TargetingPresenter::refreshGuard);
    refreshGuard();
}

void TargetingPresenter::refreshGuard() {
    instrument_.setGuard(preferences_.settings().aiming.guard(station_.station().orientation));
    Q_EMIT aimingChanged();
}

void TargetingPresenter::onSun(const QString& happened, const QString& remedy) {
    if (happened.isEmpty()) {
        return messages_.solve(kSunTopic);
    }
    messages_.warn(happened, remedy, MessageAction::kNone, kSunTopic);
}

void TargetingPresenter::aimAtStillPixel(const QPointF& still_px) {
    if (const auto& still = live_.still()) {
        aim(still_px, still->pointing, still->frame);
    }
}

void TargetingPresenter::aimAtLivePixel(const QPointF& frame_px) {
    if (const auto& pointing = live_.scene().pointing) {
        return aim(frame_px, *pointing, live_.scene().frame);
    }
    messages_.report(noReadings(), MessageAction::kOpenConnectionPage, kMoveTopic);
}

void TargetingPresenter::clickLivePixel(const QPointF& frame_px) {
    preferences_.settings().aiming.click_turns ? moveToLivePixel(frame_px) : aimAtLivePixel(frame_px);
}

void TargetingPresenter::clickStillPixel(const QPointF& still_px) {
    preferences_.settings().aiming.click_turns ? moveToStillPixel(still_px) : aimAtStillPixel(still_px);
}

void TargetingPresenter::aim(const QPointF& px, const geometry::Pointing& at, const camera::FramePtr& frame) {
    const auto ray = live_.model().rayForPixel({px.x(), px.y()}, at);
    const RangeAssumption range = ray && range_.plane() ? range_.rangeAlong(*ray, at) : live_.scene().range;
    const Settings& settings = preferences_.settings();
    const targeting::ClickMethod method{.method = settings.aiming.method,
                                        .measured_pixel_angle = settings.chosenRig().average_pixel_angle};
    const auto pointing = targeting::pointingOfClick(method, live_.model(), {px.x(), px.y()}, at, range.slope_distance_m);
    if (!pointing) {
        messages_.report(pointing.error(), MessageAction::kNone, kMoveTopic);
        return;
    }
    setTarget(*pointing, range, tr("clicked"));
    target_->method = settings.aiming.method;
    target_->click = targeting::Click{.frame = frame, .at = at, .px = {px.x(), px.y()},
                                      .slope_distance_m = range.slope_distance_m, .first_target = *pointing, .patch = {}};
    if (settings.aiming.recentre) {
        ahead_.begin(frame, target_->click->px);
    }
}

void TargetingPresenter::aimAtPoint(qint64 row_id) {
    const survey::Point* point = points_.find(row_id);
    if (!point) {
        return;
    }
    if (!hasCoordinates(*point)) {
        return setTarget(point->observation.pointing, live_.scene().range, tr("point %1").arg(point->id));
    }
    const survey::Coordinates& place = point->coordinates;
    aimAtPlace(survey::stationFrameFromGround(station_.station(), place.e_m, place.n_m, place.h_m,
                                              point->observation.target_height_m),
               RangeSource::kMeasured, tr("point %1").arg(point->id));
}

void TargetingPresenter::aimAtPlace(const Eigen::Vector3d& p_station, RangeSource source, const QString& name) {
    const auto polar = geometry::polarFromStation(p_station);
    if (!polar) {
        messages_.report(polar.error(), MessageAction::kNone, kMoveTopic);
        return;
    }
    const auto reading = instrument_.track().newest();
    setTarget(reading ? geometry::inFaceOf(reading->pointing, polar->pointing) : polar->pointing,
              {.slope_distance_m = polar->slope_distance_m, .source = source}, name);
}

void TargetingPresenter::aimAtText(const QString& ha_text, const QString& va_text) {
    const auto ha = preferences_.units().parseAngle(ha_text);
    const auto va = preferences_.units().parseAngle(va_text);
    if (!ha || !va) {
        messages_.report(!ha ? ha.error() : va.error(), MessageAction::kNone, kMoveTopic);
        return;
    }
    setTarget({.ha = core::normalized(*ha), .va = *va}, live_.scene().range, tr("typed"));
}

void TargetingPresenter::setTarget(const geometry::Pointing& pointing, const RangeAssumption& range, const QString& name) {
    abandonMove();
    messages_.solve(kMoveTopic);
    target_ = Target{.method = targeting::Method::kRigorous, .click = {}, .proof = {}, .pointing = pointing, .range = range, .name = name, .ha_text = {}, .va_text = {}, .range_text = {},
                     .state = MoveState::kAimed, .sentence = {}};
    refreshTexts();
    setState(MoveState::kAimed, tr("Target (%1): HA %2, VA %3 at %4.")
                                    .arg(name, target_->ha_text, target_->va_text, target_->range_text));
}

void TargetingPresenter::refreshTexts() {
    Q_EMIT stepChanged(stepText());
    if (!target_) {
        return;
    }
    const UnitFormat& units = preferences_.units();
    target_->ha_text = units.direction(target_->pointing.ha);
    target_->va_text = units.angle(target_->pointing.va);
    target_->range_text = rangeText(target_->range, units);
    Q_EMIT targetChanged();
}

void TargetingPresenter::setState(MoveState state, const QString& sentence) {
    if (!target_) {
        return;
    }
    target_->state = state;
    target_->sentence = sentence;
    live_.setTarget(target_->pointing, target_->range.slope_distance_m, state);
    Q_EMIT targetChanged();
}

void TargetingPresenter::setRecentring(bool on) {
    Settings next = preferences_.settings();
    next.aiming.recentre = on;
    preferences_.set(next);
}

void TargetingPresenter::setClickTurns(bool on) {
    Settings next = preferences_.settings();
    next.aiming.click_turns = on;
    preferences_.set(next);
}

void TargetingPresenter::moveToStillPixel(const QPointF& still_px) {
    if (live_.still()) {
        clearTarget();
        aimAtStillPixel(still_px);
        moveIfAimed();
    }
}

/// By the first click of a double-click: the second one need not aim again.
bool TargetingPresenter::isAimedAtLive(const QPointF& frame_px) const {
    constexpr core::Duration kDoubleClick = std::chrono::seconds(1);
    const LiveScene& scene = live_.scene();
    if (!target_ || !target_->click || target_->state != MoveState::kAimed || scene.moving || !scene.frame) {
        return false;
    }
    const targeting::Click& click = *target_->click;
    const bool is_of_still = live_.still() && live_.still()->frame == click.frame;
    return !is_of_still && QPointF(click.px.x(), click.px.y()) == frame_px &&
           scene.frame->captured_at - click.frame->captured_at <= kDoubleClick;
}

void TargetingPresenter::moveToLivePixel(const QPointF& frame_px) {
    if (!isAimedAtLive(frame_px)) {
        clearTarget();
        aimAtLivePixel(frame_px);
    }
    moveIfAimed();
}

void TargetingPresenter::moveToPoint(qint64 row_id) {
    clearTarget();
    aimAtPoint(row_id);
    moveIfAimed();
}

void TargetingPresenter::moveToPlanned(const survey::PlannedPoint& point) {
    clearTarget();
    aimAtPlace(survey::stationFrameFromGround(station_.station(), point.e_m, point.n_m, point.h_m,
                                              preferences_.settings().target_height_m),
               RangeSource::kPlanned, tr("planned point %1").arg(point.id));
    moveIfAimed();
}

void TargetingPresenter::moveToPlace(OverlayKind kind, qint64 row_id) {
    const auto place = live_.placeOf(kind, row_id);
    if (!place || kind == OverlayKind::kPoint) {
        return moveToPoint(row_id);
    }
    clearTarget();
    aimAtPlace(place->p_station, RangeSource::kAssumed, place->label);
    moveIfAimed();
}

void TargetingPresenter::moveTo(const geometry::Pointing& pointing, const QString& name) {
    setTarget(pointing, live_.scene().range, name);
    move();
}

void TargetingPresenter::bringToPixel(const QPointF& grabbed_px, const QPointF& released_px) {
    const auto& at = live_.scene().pointing;
    if (!at) {
        messages_.report(noReadings(), MessageAction::kOpenConnectionPage, kMoveTopic);
        return;
    }
    const auto next = targeting::pointingToBring(live_.model(), {grabbed_px.x(), grabbed_px.y()},
                                                 {released_px.x(), released_px.y()}, *at,
                                                 live_.scene().range.slope_distance_m);
    if (!next) {
        messages_.report(next.error(), MessageAction::kNone, kMoveTopic);
        return;
    }
    moveTo(*next, tr("dragged"));
}

void TargetingPresenter::moveIfAimed() {
    if (target_) {
        move();
    }
}

void TargetingPresenter::changeFace() {
    if (const auto start = startOfStep()) {
        setTarget(geometry::otherFace(*start), live_.scene().range, tr("other face"));
        move();
    }
}

std::optional<geometry::Pointing> TargetingPresenter::startOfStep() {
    if (isMoving() && target_) {
        return target_->pointing;  // a second press goes on from where the first one will end
    }
    if (const auto reading = instrument_.track().newest()) {
        return reading->pointing;
    }
    messages_.report(noReadings(), MessageAction::kOpenConnectionPage, kMoveTopic);
    return std::nullopt;
}

void TargetingPresenter::nudge(Direction direction) {
    const auto start = startOfStep();
    if (!start) {
        return;
    }
    const core::Angle step = preferences_.settings().arrow_step;
    const core::Angle upwards = geometry::isFaceTwo(*start) ? step : -step;  // VA grows downwards in face I only
    geometry::Pointing next = *start;
    switch (direction) {
        case Direction::kLeft: next.ha -= step; break;
        case Direction::kRight: next.ha += step; break;
        case Direction::kUp: next.va += upwards; break;
        case Direction::kDown: next.va -= upwards; break;
    }
    next.ha = core::normalized(next.ha);
    setTarget(next, live_.scene().range, tr("one step of %1").arg(stepText()));
    move();
}

QString TargetingPresenter::stepText() const {
    const core::Angle step = preferences_.settings().arrow_step;
    const double minutes = step.arcsec() / 60.0;
    if (preferences_.units().angle_unit != core::AngleUnit::kMil && std::abs(minutes - std::round(minutes)) < 1e-9) {
        return QStringLiteral("%1'").arg(std::round(minutes));
    }
    return preferences_.units().angle(step);
}

void TargetingPresenter::setStepText(const QString& text) {
    auto step = preferences_.units().parseAngle(text);
    if (step && !(step->gon() > 0.0 && step->gon() <= kUsualStepLimitGon)) {
        step = core::fail(core::ErrorKind::kLimit, tr("A step of “%1” is not possible.").arg(text),
                          tr("Type an angle above zero, up to a quarter of a turn."));
    }
    if (!step) {
        Q_EMIT stepRejected(step.error());
        return;
    }
    Settings next = preferences_.settings();
    next.arrow_step = *step;
    preferences_.set(next);
    Q_EMIT stepChanged(stepText());
}

void TargetingPresenter::clearTarget() {
    abandonMove();
    target_.reset();
    live_.setTarget(std::nullopt, 0.0, MoveState::kNone);
    Q_EMIT targetChanged();
}

}  // namespace pmts::app
