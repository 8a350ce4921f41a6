#include "pmts/app/field/recording_presenter.hpp"

#include "desk/block_intake.hpp"
#include "desk/message_topics.hpp"

#include <chrono>
#include <utility>

namespace pmts::app {

namespace {

const QString kMeasureTopic = QStringLiteral("measure");
const QString kRecordTopic = QStringLiteral("record");

QString modeName(instrument::EdmMode mode) {
    return RecordingPresenter::modeNames().value(static_cast<int>(mode));
}

}  // namespace

RecordingPresenter::RecordingPresenter(InstrumentDesk& instrument, JobDesk& job, PointsModel& points,
                                       const StationPresenter& station, RangeKeeper& range, Preferences& preferences,
                                       MessageCentre& messages, const core::Clock& clock, QObject* parent)
    : QObject(parent), instrument_(instrument), job_(job), points_(points), station_(station), range_(range),
      preferences_(preferences), messages_(messages), clock_(clock) {
    connect(&instrument_, &InstrumentDesk::pointingChanged, this, &RecordingPresenter::onPointing);
    connect(&instrument_, &InstrumentDesk::distanceMeasured, this, &RecordingPresenter::onShot);
    connect(&instrument_, &InstrumentDesk::requestFailed, this, &RecordingPresenter::onInstrumentFailed);
    connect(&instrument_, &InstrumentDesk::modeSet, this, &RecordingPresenter::onModeSet);
    connect(&instrument_, &InstrumentDesk::identityChanged, this, [this] {
        if (instrument_.choice().dialect == instrument::LineDialect::kExternal) {
            setMode(mode());
        }
    });
    blocks_ = std::make_unique<BlockIntake>(
        instrument_, job_, preferences_, messages_, clock_,
        [this](const survey::Observation& observation) { return pointOfBlock(observation); });
    connect(blocks_.get(), &BlockIntake::offerChanged, this, &RecordingPresenter::blockOffered);
    connect(&job_, &JobDesk::opened, this, &RecordingPresenter::onOpened);
    connect(&job_, &JobDesk::recorded, this, &RecordingPresenter::onRecorded);
    connect(&job_, &JobDesk::requestFailed, this, &RecordingPresenter::onJobFailed);
    connect(&points_, &PointsModel::pointsChanged, this, [this] {
        if (!id_is_typed_ && readings_.shot != ShotState::kRecording) {
            proposeId(point_id_);
        }
    });
    connect(&station_, &StationPresenter::stationChanged, this, &RecordingPresenter::reconvert);
    connect(&preferences_, &Preferences::unitsChanged, this, &RecordingPresenter::refreshTexts);
    refreshTexts();
}

RecordingPresenter::~RecordingPresenter() = default;

QStringList RecordingPresenter::modeNames() {
    return {tr("STD"), tr("TRK"), tr("D-bar"), tr("FSTD"), tr("D-bar HR")};
}

instrument::EdmMode RecordingPresenter::mode() const { return preferences_.settings().edm_mode; }

// Measure -------------------------------------------------------------------------------------------------------

void RecordingPresenter::measure() {
    if (readings_.shot == ShotState::kMeasuring) {
        return;
    }
    record_after_ = false;
    all_after_ = false;
    if (isKeptOfElsewhere() && !std::exchange(drop_asked_, true)) {
        messages_.warn(tr("The shot of point %1 is not recorded yet.").arg(submitted_.id),
                       tr("Press R to record it; press D again to drop it and measure here."), MessageAction::kRetryRecord,
                       kRecordTopic);
        messages_.cue(Cue::kFailed);
        return;
    }
    if (instrument_.connectionState() != ConnectionState::kConnected) {
        messages_.warn(tr("The instrument is not connected, so it cannot measure."), tr("Connect it first."),
                       MessageAction::kOpenConnectionPage, kMeasureTopic);
        return;
    }
    messages_.solve(kMeasureTopic);
    messages_.solve(kUsedIdTopic);
    asked_id_.clear();
    messages_.solve(kRecordTopic);
    drop_asked_ = false;
    observation_.reset();
    coordinates_.reset();
    measure_ticket_ = instrument_.measureDistance();
    setShot(ShotState::kMeasuring, tr("Measuring the distance."));
}

void RecordingPresenter::onShot(Ticket ticket, const instrument::DistanceShot& shot) {
    if (ticket != measure_ticket_) {
        return;
    }
    measure_ticket_ = 0;
    evidence_ = collect_evidence ? collect_evidence(shot.pointing) : std::nullopt;
    observation_ = survey::Observation{.pointing = shot.pointing,
                                       .slope_distance_m = shot.slope_distance_m,
                                       .absurd_reason = {},
                                       .target_height_m = preferences_.settings().target_height_m,
                                       .edm_mode = modeName(shot.mode),
                                       .time_taken_s = std::chrono::duration<double>(shot.time_taken).count(),
                                       .utc = shot.utc,
                                       .raw_reply = shot.raw_reply,
                                       .source = QStringLiteral("pmts")};
    range_.addShot(shot.pointing, shot.slope_distance_m);
    setShot(ShotState::kMeasured, tr("Measured in %1 s.").arg(observation_->time_taken_s, 0, 'f', 1));
    if (std::exchange(record_after_, false)) {
        convert();
        record();
    }
}

void RecordingPresenter::onInstrumentFailed(Ticket ticket, const core::Error& error) {
    if (ticket == mode_ticket_ && ticket != 0) {
        mode_ticket_ = 0;
        const bool is_said_elsewhere = error.kind == core::ErrorKind::kCancelled ||
                                       error.kind == core::ErrorKind::kLinkLost ||
                                       error.kind == core::ErrorKind::kNotConnected;
        if (!is_said_elsewhere) {  // the connection's own bar speaks of a lost line
            messages_.report(error, MessageAction::kNone, QStringLiteral("mode"));
        }
        Q_EMIT modeChanged(mode());
    }
    if (ticket != measure_ticket_ || ticket == 0) {
        return;
    }
    measure_ticket_ = 0;
    record_after_ = false;
    if (error.kind == core::ErrorKind::kAbsurdPoint) {
        return keepAbsurd(error);
    }
    setShot(ShotState::kNone, error.sentence());
    if (error.kind != core::ErrorKind::kCancelled) {
        messages_.report(error, MessageAction::kNone, kMeasureTopic);
        messages_.cue(Cue::kFailed);
    }
}

void RecordingPresenter::keepAbsurd(const core::Error& error) {
    messages_.cue(Cue::kFailed);
    const auto reading = instrument_.track().newest();
    if (!reading) {
        return setShot(ShotState::kNone, error.sentence());
    }
    evidence_ = collect_evidence ? collect_evidence(reading->pointing) : std::nullopt;
    observation_ = survey::Observation{.pointing = reading->pointing,
                                       .slope_distance_m = std::nullopt,
                                       .absurd_reason = error.happened,
                                       .target_height_m = preferences_.settings().target_height_m,
                                       .edm_mode = modeName(mode()),
                                       .time_taken_s = 0.0,
                                       .utc = clock_.utcNow(),
                                       .raw_reply = error.detail,
                                       .source = QStringLiteral("pmts")};
    setShot(ShotState::kAbsurd, error.happened + u' ' + tr("Measure again, or press R to record the direction as absurd."));
}

void RecordingPresenter::cancel() {
    record_after_ = false;
    all_after_ = false;
    if (readings_.shot == ShotState::kMeasuring) {
        instrument_.stop();
    }
}

// Convert -------------------------------------------------------------------------------------------------------

void RecordingPresenter::convert() {
    if (!observation_) {
        return say(readings_.shot == ShotState::kMeasuring ? tr("The distance is still being measured.")
                                                           : tr("There is no distance yet: measure first (D)."));
    }
    if (!observation_->slope_distance_m) {
        return say(tr("The shot is absurd and has no distance: measure again (D)."));
    }
    const auto coordinates = survey::coordinatesOf(station_.station(), *observation_, survey::InstrumentAccuracy{});
    if (!coordinates) {
        messages_.report(coordinates.error(), MessageAction::kNone, kMeasureTopic);
        return;
    }
    coordinates_ = *coordinates;
    if (readings_.shot == ShotState::kMeasured) {
        setShot(ShotState::kConverted, tr("Converted from station %1.").arg(station_.station().name));
    } else {
        refreshTexts();
    }
}

void RecordingPresenter::reconvert() {
    if (coordinates_ && readings_.shot != ShotState::kRecording && readings_.shot != ShotState::kRecorded) {
        convert();
    }
}

// Record --------------------------------------------------------------------------------------------------------

void RecordingPresenter::record() {
    if (readings_.shot == ShotState::kRecorded && asked_id_.isEmpty()) {
        return say(tr("This shot is recorded already, as point %1: measure again (D).").arg(recorded_id_));
    }
    if (readings_.shot == ShotState::kRecording) {
        return;
    }
    if (!observation_) {
        return say(readings_.shot == ShotState::kMeasuring ? tr("The distance is still being measured.")
                                                           : tr("There is nothing to record: measure first (D)."));
    }
    if (isKeptOfElsewhere() && job_.isOpen()) {
        return submit(submitted_);  // ID, code and height are those of its own target, not of the next one
    }
    submitShot();
}

bool RecordingPresenter::isKeptOfElsewhere() const {
    return readings_.shot == ShotState::kKept && readings_.shot_is_elsewhere;
}

void RecordingPresenter::recordAgain() {
    if (observation_ && readings_.shot != ShotState::kRecording) {
        submitShot();
    }
}

void RecordingPresenter::submitShot() {
    if (!job_.isOpen()) {
        if (!isKeptOfElsewhere()) {  // what is typed now is meant for the next target
            observation_->target_height_m = preferences_.settings().target_height_m;
            submitted_ = pointOf(*observation_);
        }
        messages_.warn(tr("No job is open, so the point cannot be recorded; the shot is kept."),
                       tr("Open a job, then press R."), MessageAction::kOpenJob, kRecordTopic);
        return setShot(ShotState::kKept, tr("The shot is kept until a job is open."));
    }
    observation_->target_height_m = preferences_.settings().target_height_m;
    if (asksAboutId()) {
        return;
    }
    submit(pointOf(*observation_));
}

void RecordingPresenter::submit(const survey::Point& point) {
    submitted_ = point;
    drop_asked_ = false;
    record_ticket_ = job_.record(point, evidence_);
    setShot(ShotState::kRecording, tr("Recording point %1.").arg(point.id));
}

/// Two points of one ID may be meant (a second face, a check), but never unknowingly.
bool RecordingPresenter::asksAboutId() {
    messages_.solve(kUsedIdTopic);
    if (points_.findId(point_id_) == nullptr || asked_id_ == point_id_) {
        asked_id_.clear();
        return false;
    }
    asked_id_ = point_id_;
    messages_.warn(tr("Not recorded yet: the job has a point %1 already.").arg(point_id_),
                   tr("Type another ID (%1 is free), or press R again to record a second point %2.")
                       .arg(survey::freePointId(point_id_, [this](const QString& id) { return points_.isIdUsed(id); }),
                            point_id_),
                   MessageAction::kRecordSameId, kUsedIdTopic);
    messages_.cue(Cue::kFailed);
    readings_.sentence = tr("Point %1 is in the job already: R records a second one.").arg(point_id_);
    Q_EMIT readingsChanged();
    return true;
}

survey::Point RecordingPresenter::pointOf(const survey::Observation& observation) const {
    survey::Point point;
    point.id = point_id_;
    point.code = code_;
    point.remark = remark_;
    point.station_name = station_.station().name;
    point.observation = observation;
    // From the observation, never from the display: the target height may have been typed after M.
    if (const auto place = survey::coordinatesOf(station_.station(), observation, survey::InstrumentAccuracy{})) {
        point.coordinates = *place;
    }
    return point;
}

void RecordingPresenter::all() {
    if (isBusy()) {
        return;
    }
    if (readings_.shot == ShotState::kKept) {
        asked_id_.clear();  // Space is no answer to a question
        all_after_ = isKeptOfElsewhere() && job_.isOpen();
        return record();  // the shot that could not be written comes first
    }
    measure();
    record_after_ = readings_.shot == ShotState::kMeasuring;
}

void RecordingPresenter::onRecorded(Ticket ticket, const survey::Point& point) {
    const bool is_block = blocks_->takeTicket(ticket);
    if (!is_block && (ticket != record_ticket_ || ticket == 0)) {
        return;
    }
    const bool duplicate = points_.findId(point.id) != nullptr;
    points_.addRecorded(point);
    messages_.solve(kRecordTopic);
    if (!is_block) {
        record_ticket_ = 0;
        recorded_id_ = point.id;
        coordinates_ = hasCoordinates(point) ? std::optional(point.coordinates) : std::nullopt;
        setShot(ShotState::kRecorded, tr("Point %1 is recorded.").arg(point.id));
        remark_.clear();
    }
    if (duplicate) {
        messages_.warn(tr("There are two points %1 now.").arg(point.id), tr("Press P to give one of them another ID."),
                       MessageAction::kNone, QStringLiteral("duplicate"));
    }
    messages_.toast(tr("Point %1 is recorded.").arg(point.id));
    messages_.cue(Cue::kRecorded);
    rememberCode(point.code);
    if (point_id_ == point.id) {
        proposeId(survey::nextPointId(point.id));
    }
    job_.setMeta(QStringLiteral("next_point_id"), point_id_);
    job_.setMeta(QStringLiteral("last_code"), code_);
    Q_EMIT nextPointChanged();
    Q_EMIT codesChanged();
    Q_EMIT pointRecorded(point);
    if (std::exchange(all_after_, false)) {
        all();
    }
}

void RecordingPresenter::onJobFailed(Ticket ticket, const core::Error& error) {
    if (ticket != record_ticket_ || ticket == 0) {
        return;
    }
    record_ticket_ = 0;
    all_after_ = false;
    core::Error told = error;
    told.happened = tr("Point %1 is not recorded; the shot is kept. ").arg(submitted_.id) + error.happened;
    messages_.report(told, MessageAction::kRetryRecord, kRecordTopic);
    messages_.cue(Cue::kFailed);
    setShot(ShotState::kKept, tr("Not recorded: press R to try again."));
}

// Mode ----------------------------------------------------------------------------------------------------------

void RecordingPresenter::setMode(instrument::EdmMode mode) {
    if (instrument_.connectionState() == ConnectionState::kConnected) {
        mode_ticket_ = instrument_.setMode(mode);
    } else {
        onModeSet(0, mode);  // kept for the next connection
    }
}

void RecordingPresenter::onModeSet(Ticket, instrument::EdmMode mode) {
    mode_ticket_ = 0;
    messages_.solve(QStringLiteral("mode"));
    if (mode != preferences_.settings().edm_mode) {
        Settings next = preferences_.settings();
        next.edm_mode = mode;
        preferences_.set(next);
    }
    refreshTexts();
    Q_EMIT modeChanged(mode);
}

// Blocks nobody asked for -----------------------------------------------------------------------------------------

const std::optional<instrument::UnsolicitedBlock>& RecordingPresenter::offeredBlock() const { return blocks_->offered(); }

void RecordingPresenter::acceptBlock() { blocks_->accept(); }

void RecordingPresenter::dismissBlock() { blocks_->dismiss(); }

survey::Point RecordingPresenter::pointOfBlock(survey::Observation observation) const {
    observation.target_height_m = preferences_.settings().target_height_m;
    observation.edm_mode = modeName(mode());
    return pointOf(observation);
}

}  // namespace pmts::app
