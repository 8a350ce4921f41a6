#include "pmts/app/targeting_presenter.hpp"

#include "pmts/geometry/polar.hpp"

#include <cmath>

namespace pmts::app {

namespace {

constexpr double kUsualStepLimitGon = 100.0;
const QString kTopic = QStringLiteral("move");

/// The telescope keeps its face: a click never turns it through the zenith.
geometry::Pointing inFaceOf(const geometry::Pointing& reference, const geometry::Pointing& target) {
    return geometry::isFaceTwo(reference) == geometry::isFaceTwo(target) ? target : geometry::otherFace(target);
}

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
}

bool TargetingPresenter::isMoving() const { return ticket_ != 0; }

void TargetingPresenter::aimAtStillPixel(const QPointF& still_px) {
    if (const auto& still = live_.still()) {
        aim(still_px, still->pointing);
    }
}

void TargetingPresenter::aimAtLivePixel(const QPointF& frame_px) {
    if (const auto& pointing = live_.scene().pointing) {
        return aim(frame_px, *pointing);
    }
    messages_.report(noReadings(), MessageAction::kOpenConnectionPage, kTopic);
}

void TargetingPresenter::aim(const QPointF& px, const geometry::Pointing& at) {
    const RangeAssumption range = live_.scene().range;
    const auto pointing = live_.model().pointingForPixel({px.x(), px.y()}, at, range.slope_distance_m);
    if (!pointing) {
        messages_.report(pointing.error(), MessageAction::kNone, kTopic);
        return;
    }
    setTarget(inFaceOf(at, *pointing), range, tr("clicked"));
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
        messages_.report(polar.error(), MessageAction::kNone, kTopic);
        return;
    }
    const auto reading = instrument_.track().newest();
    setTarget(reading ? inFaceOf(reading->pointing, polar->pointing) : polar->pointing,
              {.slope_distance_m = polar->slope_distance_m, .source = source}, name);
}

void TargetingPresenter::aimAtText(const QString& ha_text, const QString& va_text) {
    const auto ha = preferences_.units().parseAngle(ha_text);
    const auto va = preferences_.units().parseAngle(va_text);
    if (!ha || !va) {
        messages_.report(!ha ? ha.error() : va.error(), MessageAction::kNone, kTopic);
        return;
    }
    setTarget({.ha = core::normalized(*ha), .va = *va}, live_.scene().range, tr("typed"));
}

void TargetingPresenter::setTarget(const geometry::Pointing& pointing, const RangeAssumption& range, const QString& name) {
    abandonMove();
    messages_.solve(kTopic);
    target_ = Target{.pointing = pointing, .range = range, .name = name, .ha_text = {}, .va_text = {}, .range_text = {},
                     .state = MoveState::kAimed, .sentence = {}};
    refreshTexts();
    setState(MoveState::kAimed, tr("Target (%1): HA %2, VA %3 at %4.")
                                    .arg(name, target_->ha_text, target_->va_text, target_->range_text));
}

void TargetingPresenter::abandonMove() {
    if (ticket_ != 0) {  // a new target while turning: the old move ends here, its outcome is nobody's any more
        ticket_ = 0;
        instrument_.stop();
        Q_EMIT movingChanged(false);
    }
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

void TargetingPresenter::move() {
    if (!target_) {
        messages_.warn(tr("There is no target to turn to."), tr("Click it in the live view or in the still first."),
                       MessageAction::kNone, kTopic);
        return;
    }
    if (instrument_.connectionState() != ConnectionState::kConnected) {
        messages_.warn(tr("The instrument is not connected, so it cannot turn."), tr("Connect it, then press Move again."),
                       MessageAction::kOpenConnectionPage, kTopic);
        return;
    }
    abandonMove();
    messages_.solve(kTopic);
    ticket_ = instrument_.turnTo(target_->pointing, preferences_.settings().turn_tolerance);
    setState(MoveState::kQueued, tr("The move waits for its turn on the line."));
    Q_EMIT movingChanged(true);
}

void TargetingPresenter::moveToStillPixel(const QPointF& still_px) {
    if (live_.still()) {
        clearTarget();
        aimAtStillPixel(still_px);
        moveIfAimed();
    }
}

void TargetingPresenter::moveToLivePixel(const QPointF& frame_px) {
    clearTarget();
    aimAtLivePixel(frame_px);
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
               RangeSource::kAssumed, tr("planned point %1").arg(point.id));
    moveIfAimed();
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
    messages_.report(noReadings(), MessageAction::kOpenConnectionPage, kTopic);
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

void TargetingPresenter::stop() { instrument_.stop(); }

void TargetingPresenter::onTurned(Ticket ticket, const geometry::Pointing& arrived) {
    if (ticket != ticket_ || ticket_ == 0) {
        return;
    }
    ticket_ = 0;
    const UnitFormat& units = preferences_.units();
    setState(MoveState::kArrived, tr("Arrived at HA %1, VA %2.").arg(units.direction(arrived.ha), units.angle(arrived.va)));
    messages_.cue(Cue::kArrived);
    Q_EMIT movingChanged(false);
}

void TargetingPresenter::onFailed(Ticket ticket, const core::Error& error) {
    if (ticket != ticket_ || ticket_ == 0) {
        return;
    }
    ticket_ = 0;
    setState(MoveState::kLost, error.sentence());
    if (error.kind != core::ErrorKind::kCancelled) {
        messages_.report(error, MessageAction::kNone, kTopic);
        messages_.cue(Cue::kFailed);
    }
    Q_EMIT movingChanged(false);
}

void TargetingPresenter::onProgress(const instrument::Progress& progress) {
    if (isMoving() && progress.activity == instrument::Activity::kTurning) {
        setState(MoveState::kTurning, tr("Turning to HA %1, VA %2 (%3 %).")
                                          .arg(target_->ha_text, target_->va_text)
                                          .arg(qRound(progress.fraction * 100.0)));
    }
}

}  // namespace pmts::app
