#include "pmts/app/line/two_face_presenter.hpp"

#include "pmts/app/field/recording_presenter.hpp"
#include "pmts/geometry/polar.hpp"

#include <chrono>
#include <cmath>

namespace pmts::app {
namespace {

const QString kTopic = QStringLiteral("two_faces");
constexpr core::Angle kServoTolerance = core::Angle::fromCc(10);
constexpr core::Angle kSameTarget = core::Angle::fromGon(0.5);

QString mgon(core::Angle angle) { return QString::number(angle.mgon(), 'f', 1); }

/// Of one face, for the record: what the circles and the distance meter said, then the block itself.
QString rawText(const instrument::DistanceShot& shot) {
    const QString face = geometry::isFaceTwo(shot.pointing) ? QStringLiteral("II") : QStringLiteral("I");
    return QStringLiteral("face %1: HA %2 VA %3 SD %4: %5")
        .arg(face)
        .arg(shot.pointing.ha.gon(), 0, 'f', 5)
        .arg(shot.pointing.va.gon(), 0, 'f', 5)
        .arg(shot.slope_distance_m, 0, 'f', 4)
        .arg(shot.raw_reply.simplified());
}

}  // namespace

TwoFacePresenter::TwoFacePresenter(InstrumentDesk& instrument, JobDesk& job, PointsModel& points,
                                   const StationPresenter& station, const Preferences& preferences,
                                   MessageCentre& messages, QObject* parent)
    : QObject(parent),
      instrument_(instrument),
      job_(job),
      points_(points),
      station_(station),
      preferences_(preferences),
      messages_(messages) {
    connect(&instrument_, &InstrumentDesk::distanceMeasured, this, &TwoFacePresenter::onShot);
    connect(&instrument_, &InstrumentDesk::turned, this, [this](Ticket ticket) {
        if (ticket == ticket_ && step_ == TwoFaceStep::kTurning) {
            setStep(TwoFaceStep::kSecond);
        }
    });
    connect(&instrument_, &InstrumentDesk::requestFailed, this, &TwoFacePresenter::onFailed);
    connect(&preferences_, &Preferences::changed, this, &TwoFacePresenter::changed);
    connect(&points_, &PointsModel::pointsChanged, this, &TwoFacePresenter::changed);  // another ID is proposed
    connect(&job_, &JobDesk::recorded, this, [this](Ticket ticket, const survey::Point& point) {
        if (ticket == ticket_ && step_ == TwoFaceStep::kRecording) {
            points_.addRecorded(point);
            messages_.toast(tr("Point %1 is recorded as the mean of both faces.").arg(point.id));
            messages_.cue(Cue::kRecorded);
            discard();
            Q_EMIT recorded(point.id);
        }
    });
    connect(&job_, &JobDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == ticket_ && step_ == TwoFaceStep::kRecording) {
            messages_.report(error, job_.isOpen() ? MessageAction::kNone : MessageAction::kOpenJob, kTopic);
            setStep(TwoFaceStep::kDone);
        }
    });
}

void TwoFacePresenter::setStep(TwoFaceStep step) {
    step_ = step;
    Q_EMIT changed();
}

QString TwoFacePresenter::instruction() const {
    switch (step_) {
        case TwoFaceStep::kFirst:
            return tr("Aim at the point in either face and measure.");
        case TwoFaceStep::kMeasuring:
            return tr("Measuring.");
        case TwoFaceStep::kTurning:
            return tr("Turning to the other face.");
        case TwoFaceStep::kSecond:
            return tr("Aim at the same point again and measure in this face.");
        case TwoFaceStep::kDone:
            return tr("Look at the differences, then record the mean or discard it.");
        case TwoFaceStep::kRecording:
            return tr("Recording.");
    }
    return {};
}

void TwoFacePresenter::measure() {
    if (isBusy()) {
        return;
    }
    messages_.solve(kTopic);
    if (instrument_.connectionState() != ConnectionState::kConnected) {
        messages_.warn(tr("The instrument is not connected, so it cannot measure."), tr("Connect it first."),
                       MessageAction::kOpenConnectionPage, kTopic);
        return;
    }
    if (step_ == TwoFaceStep::kDone) {
        discard();
    }
    ticket_ = instrument_.measureDistance();
    setStep(TwoFaceStep::kMeasuring);
}

void TwoFacePresenter::onShot(Ticket ticket, const instrument::DistanceShot& shot) {
    if (ticket != ticket_ || step_ != TwoFaceStep::kMeasuring) {
        return;
    }
    if (!first_) {
        first_ = shot;
        ticket_ = instrument_.turnTo(geometry::otherFace(shot.pointing), kServoTolerance);
        setStep(TwoFaceStep::kTurning);
        return;
    }
    if (geometry::isFaceTwo(shot.pointing) == geometry::isFaceTwo(first_->pointing)) {
        messages_.warn(tr("That was the same face again."), tr("Turn to the other face, aim, then measure."),
                       MessageAction::kNone, kTopic);
        return setStep(TwoFaceStep::kSecond);
    }
    if (geometry::separation(shot.pointing, first_->pointing) > kSameTarget) {
        messages_.warn(tr("That is another point: both faces differ by more than 0.5 gon."),
                       tr("Aim at the point of the first face."), MessageAction::kNone, kTopic);
        return setStep(TwoFaceStep::kSecond);
    }
    second_ = shot;
    setStep(TwoFaceStep::kDone);
}

void TwoFacePresenter::onFailed(Ticket ticket, const core::Error& error) {
    const bool ours = ticket == ticket_ && (step_ == TwoFaceStep::kMeasuring || step_ == TwoFaceStep::kTurning);
    if (!ours || ticket == 0) {
        return;
    }
    if (error.kind != core::ErrorKind::kCancelled) {
        messages_.report(error, MessageAction::kNone, kTopic);
    }
    setStep(first_ ? TwoFaceStep::kSecond : TwoFaceStep::kFirst);
}

void TwoFacePresenter::cancel() {
    if (canCancel()) {
        instrument_.cancel(ticket_);
    }
}

void TwoFacePresenter::discard() {
    first_.reset();
    second_.reset();
    asked_id_.clear();
    ticket_ = 0;
    setStep(TwoFaceStep::kFirst);
}

std::optional<geometry::FacePair> TwoFacePresenter::pair() const {
    if (!first_ || !second_) {
        return std::nullopt;
    }
    return geometry::isFaceTwo(first_->pointing) ? geometry::FacePair{second_->pointing, first_->pointing}
                                                 : geometry::FacePair{first_->pointing, second_->pointing};
}

/// The differences less what the kept test of this instrument explains.
geometry::FaceDifference TwoFacePresenter::unexplained(const geometry::FacePair& pair) const {
    auto difference = geometry::faceDifference(pair);
    const auto& identity = instrument_.identity();
    const auto* const test = identity ? preferences_.settings().instrument_care.testOf(identity->serial_number) : nullptr;
    if (test != nullptr) {
        const core::Angle va = geometry::meanOfFaces(pair).va;
        const core::Angle tilting = test->errors.tilting ? test->errors.tilting->value : core::Angle();
        difference.ha -= 2 * (test->errors.collimation.value + tilting * core::cos(va)) / core::sin(va);
        difference.va -= 2 * test->errors.index.value;
    }
    return difference;
}

StatusItem TwoFacePresenter::outcome() const {
    const auto both = pair();
    if (!both) {
        return {DeviceState::kIdle, first_ ? tr("One face is measured.") : tr("No face is measured yet."), {}};
    }
    const auto difference = geometry::faceDifference(*both);
    const auto left = unexplained(*both);
    const double distance_m = first_->slope_distance_m - second_->slope_distance_m;
    const auto& care = preferences_.settings().instrument_care;
    const UnitFormat& units = preferences_.units();
    const auto mean = geometry::meanOfFaces(*both);
    const QString text = tr("Mean HA %1, VA %2, SD %3\nFaces differ by %4 mgon in HA, %5 mgon in VA, %6 mm in SD")
                             .arg(units.direction(mean.ha), units.angle(mean.va),
                                  units.length((first_->slope_distance_m + second_->slope_distance_m) / 2),
                                  mgon(difference.ha), mgon(difference.va))
                             .arg(distance_m * 1000, 0, 'f', 1);
    const bool within = core::abs(left.ha) * core::sin(mean.va) <= care.face_limit &&
                        core::abs(left.va) <= care.face_limit &&
                        std::abs(distance_m) <= 2 * care.face_limit_m;  // each face from their mean
    const QString limits = tr("%1 mgon, %2 mm; after the kept test %3 and %4 mgon are left")
                               .arg(care.face_limit.mgon())
                               .arg(2 * care.face_limit_m * 1000)
                               .arg(mgon(left.ha), mgon(left.va));
    return within ? StatusItem{DeviceState::kGood, text, tr("Within the limits: %1.").arg(limits)}
                  : StatusItem{DeviceState::kWarning, text,
                               tr("Beyond the limits: %1. Aim and measure again, or test the instrument.").arg(limits)};
}

QString TwoFacePresenter::proposedId() const {
    const QString last = points_.points().empty() ? QStringLiteral("0") : points_.points().back().id;
    return survey::freePointId(survey::nextPointId(last), [this](const QString& id) { return points_.isIdUsed(id); });
}

survey::Observation TwoFacePresenter::meanObservation() const {
    const auto seconds = std::chrono::duration<double>(first_->time_taken + second_->time_taken).count();
    return {.pointing = geometry::meanOfFaces(*pair()),
            .slope_distance_m = (first_->slope_distance_m + second_->slope_distance_m) / 2,
            .absurd_reason = {},
            .target_height_m = preferences_.settings().target_height_m,
            .edm_mode = RecordingPresenter::modeNames().value(static_cast<int>(second_->mode)),
            .time_taken_s = seconds,
            .utc = second_->utc,
            .raw_reply = rawText(*first_) + u'\n' + rawText(*second_),
            .source = QStringLiteral("two_faces")};
}

/// Two points of one ID may be meant, but never unknowingly.
bool TwoFacePresenter::asksAboutId(const QString& id) {
    if (!points_.isIdUsed(id) || asked_id_ == id) {
        return false;
    }
    asked_id_ = id;
    messages_.warn(tr("The job has a point %1 already.").arg(id), tr("Type another ID, or record again to keep both."),
                   MessageAction::kNone, kTopic);
    messages_.cue(Cue::kFailed);
    return true;
}

void TwoFacePresenter::record(const QString& id, const QString& code) {
    if (step_ != TwoFaceStep::kDone || id.trimmed().isEmpty()) {
        return;
    }
    messages_.solve(kTopic);
    if (asksAboutId(id.trimmed())) {
        return;
    }
    survey::Point point;
    point.id = id.trimmed();
    point.code = code.trimmed();
    point.station_name = station_.station().name;
    point.observation = meanObservation();
    const auto place = survey::coordinatesOf(station_.station(), point.observation, survey::InstrumentAccuracy{});
    if (!place) {
        messages_.report(place.error(), MessageAction::kNone, kTopic);
        return;
    }
    point.coordinates = *place;
    ticket_ = job_.record(point);
    setStep(TwoFaceStep::kRecording);
}

}  // namespace pmts::app
