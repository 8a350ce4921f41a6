#include "block_intake.hpp"

#include <chrono>
#include <utility>

namespace pmts::app {

namespace {

constexpr core::Angle kSamePlace = core::Angle::fromMgon(2);  ///< five sigma of two readings, and more
constexpr core::Duration kLookBack = std::chrono::seconds(2), kLookStep = std::chrono::milliseconds(100);
constexpr core::Duration kStreamPause = std::chrono::milliseconds(1500);  ///< nobody presses REG faster than this
const QString kTopic = QStringLiteral("block");

}  // namespace

BlockIntake::BlockIntake(InstrumentDesk& instrument, JobDesk& job, const Preferences& preferences, MessageCentre& messages,
                         const core::Clock& clock, MakePoint make_point, QObject* parent)
    : QObject(parent), instrument_(instrument), job_(job), preferences_(preferences), messages_(messages), clock_(clock),
      make_point_(std::move(make_point)) {
    connect(&instrument_, &InstrumentDesk::unsolicitedBlock, this, &BlockIntake::onBlock);
    connect(&job_, &JobDesk::requestFailed, this, &BlockIntake::onJobFailed);
}

void BlockIntake::onBlock(const instrument::UnsolicitedBlock& block) {
    const QString source = sourceOfNext();
    const UnsolicitedPolicy policy = preferences_.settings().unsolicited;
    if (policy == UnsolicitedPolicy::kIgnore) {
        return;
    }
    if (!block.ha || !block.va) {
        return sayWhatIsMissing(block);
    }
    if (const auto circles = contradiction({.ha = *block.ha, .va = *block.va})) {
        return sayThatItIsDamaged(block, *circles);
    }
    if (policy == UnsolicitedPolicy::kRecord) {
        return record(block, source);
    }
    if (!isOfOwnShot()) {  // that shot is on the desk already
        offer(block, source);
    }
}

bool BlockIntake::isOfOwnShot() const { return instrument_.progress().activity == instrument::Activity::kMeasuring; }

/// The wire does not say which way was chosen on the instrument. In slave mode a block comes by itself with every
/// distance; REG is dead while one is measured, and a person presses it now and then.
QString BlockIntake::sourceOfNext() {
    const auto newest = instrument_.track().newest();
    const auto at = newest ? std::optional(newest->at) : std::nullopt;
    const auto last = std::exchange(last_at_, at);
    const bool is_stream = at && last && *at - *last < kStreamPause;
    return isOfOwnShot() || is_stream ? QStringLiteral("slave") : QStringLiteral("reg_key");
}

/// A digit that is lost on the wire leaves a number, and nobody can ask for this block again. The circles were read before
/// and after it; while they move, it may be of anywhere on the way.
std::optional<geometry::Pointing> BlockIntake::contradiction(const geometry::Pointing& said) const {
    const PointingTrack& track = instrument_.track();
    const auto newest = track.newest();
    if (!newest || clock_.now() - newest->at > kLookBack) {
        return std::nullopt;  // nobody reads the circles while the panel has control
    }
    for (core::Duration back{0}; back <= kLookBack; back += kLookStep) {
        const auto then = track.at(newest->at - back);
        const bool agrees = then && core::abs(core::normalizedSigned(said.ha - then->pointing.ha)) <= kSamePlace &&
                            core::abs(core::normalizedSigned(said.va - then->pointing.va)) <= kSamePlace;
        if (agrees || (then && then->moving)) {
            return std::nullopt;
        }
    }
    return newest->pointing;
}

void BlockIntake::sayThatItIsDamaged(const instrument::UnsolicitedBlock& block, const geometry::Pointing& circles) {
    const UnitFormat& units = preferences_.units();
    messages_.warn(tr("A registered point arrived damaged: it says HA %1, VA %2, the circles say HA %3, VA %4. Nothing was recorded.")
                       .arg(units.direction(*block.ha), units.angle(*block.va), units.direction(circles.ha), units.angle(circles.va)),
                   tr("Press REG again; check the cable when it comes again and again."), MessageAction::kShowLog, kTopic);
    messages_.cue(Cue::kFailed);
}

void BlockIntake::sayWhatIsMissing(const instrument::UnsolicitedBlock& block) {
    const bool has_place = block.e_m && block.n_m;
    messages_.warn(has_place ? tr("The instrument sent only coordinates, without the readings they come from; nothing was recorded.")
                             : tr("The instrument sent a block without both angles; nothing was recorded."),
                   tr("Choose output table 0 (HA, VA, SD) for the serial interface on the instrument, then press REG again."),
                   MessageAction::kShowLog, kTopic);
}

void BlockIntake::offer(const instrument::UnsolicitedBlock& block, const QString& source) {
    offered_ = block;
    offered_source_ = source;
    const QString sentence = tr("The instrument registered a point: HA %1, VA %2.")
                                 .arg(preferences_.units().direction(*block.ha), preferences_.units().angle(*block.va));
    messages_.warn(sentence, tr("Record it as %1?").arg(pointOf(block, source).id), MessageAction::kAcceptBlock, kTopic);
    Q_EMIT offerChanged(sentence);
}

void BlockIntake::accept() {
    if (const auto block = offered_) {
        endOffer();
        record(*block, offered_source_);
    }
}

void BlockIntake::dismiss() { endOffer(); }

void BlockIntake::endOffer() {
    offered_.reset();
    messages_.solve(kTopic);
    Q_EMIT offerChanged({});
}

void BlockIntake::record(const instrument::UnsolicitedBlock& block, const QString& source) {
    tickets_.insert(job_.record(pointOf(block, source)));
}

survey::Point BlockIntake::pointOf(const instrument::UnsolicitedBlock& block, const QString& source) const {
    survey::Observation observation;
    observation.pointing = {.ha = *block.ha, .va = *block.va};
    observation.slope_distance_m = block.slope_distance_m;
    if (!block.slope_distance_m) {
        observation.absurd_reason = tr("The registered block holds no distance.");
    }
    observation.utc = clock_.utcNow();
    observation.raw_reply = block.raw;
    observation.source = source;
    survey::Point point = make_point_(observation);
    point.id = block.point_number.isEmpty() ? point.id : block.point_number;
    point.code = block.point_code.isEmpty() ? point.code : block.point_code;
    point.remark.clear();
    return point;
}

void BlockIntake::onJobFailed(Ticket ticket, const core::Error& error) {
    if (tickets_.remove(ticket)) {
        messages_.report(error, MessageAction::kOpenJob, QStringLiteral("record"));
        messages_.cue(Cue::kFailed);
    }
}

}  // namespace pmts::app
