#include "surveyor.hpp"

#include "pmts/blackbox/recording.hpp"
#include "record_check.hpp"

#include <algorithm>
#include <cstdio>

namespace pmts::soak {
namespace {

using namespace std::chrono_literals;

constexpr core::Duration kLongestAction = 15min;  ///< the longest limits of driver and reconnecting together are shorter
constexpr core::Duration kBlackBoxSpan = 6h;     ///< recorded at the end; its disk has to keep up with virtual time
constexpr double kPartOfImpatientShots = 0.1;    ///< another move is asked for while the distance is pending
constexpr double kPartOfAcceptedBlocks = 0.7;

}  // namespace

Surveyor::Surveyor(SoakField& field, FaultSchedule& faults, unsigned seed) : field_(field), faults_(faults), random_(seed) {
    const auto hear = [this](const app::Message& message) {
        last_word_ = message.happened;
        last_word_at_ = field_.time.now();
    };
    QObject::connect(&field_.messages, &app::MessageCentre::toastShown, &field_.recording, hear);
    QObject::connect(&field_.messages, &app::MessageCentre::barKept, &field_.recording, hear);
    QObject::connect(&field_.recording, &app::RecordingPresenter::pointRecorded, &field_.recording,
                     [this](const survey::Point& point) { check(point); });
    QObject::connect(&field_.recording, &app::RecordingPresenter::blockOffered, &field_.recording,
                     [this](const QString& sentence) {
                         if (!sentence.isEmpty()) {
                             considerBlock();
                         }
                     });
}

void Surveyor::work(core::Duration span) {
    const core::Duration end = field_.time.now() + span;
    core::Duration next_calm = field_.time.now() + 4h;
    faults_.start();
    while (field_.time.now() < end && tally_.deadlocks == 0) {
        if (!boxed_from_ && end - field_.time.now() < kBlackBoxSpan) {
            field_.startBlackBox();
            boxed_from_ = recorded_.size();
        }
        if (turn()) {
            record();
        }
        rest();
        if (field_.time.now() >= next_calm) {
            demandWork();
            next_calm = field_.time.now() + 4h;
        }
    }
    demandWork();
    compareWithFile();
    compareWithBlackBox();
}

/// One minute in the mean: walking, writing, looking.
void Surveyor::rest() { field_.pass(std::chrono::seconds(std::uniform_int_distribution(5, 90)(random_))); }

void Surveyor::askForAMove() {
    const double ha_gon = std::uniform_real_distribution(-50.0, 130.0)(random_);
    const double va_gon = std::uniform_real_distribution(85.0, 115.0)(random_);
    began_at_ = field_.time.now();
    field_.targeting.aimAtText(QStringLiteral("%1 gon").arg(ha_gon), QStringLiteral("%1 gon").arg(va_gon));
    field_.targeting.move();
}

bool Surveyor::turn() {
    askForAMove();
    if (!field_.until([this] { return !field_.targeting.isMoving(); }, kLongestAction)) {
        ++tally_.deadlocks;
        complain("a move did not end", last_word_);
        return false;
    }
    judgeMove();
    return field_.targeting.target() && field_.targeting.target()->state == app::MoveState::kArrived;
}

void Surveyor::judgeMove() {
    if (field_.targeting.target() && field_.targeting.target()->state == app::MoveState::kArrived) {
        ++tally_.turned;
        return;
    }
    const bool was_tried = field_.targeting.target() && field_.targeting.target()->state != app::MoveState::kAimed;
    failed(was_tried ? field_.targeting.target()->sentence : QString());
}

bool Surveyor::record() {
    const std::size_t before = own_records_;
    began_at_ = field_.time.now();
    const bool is_kept = field_.recording.readings().shot == app::ShotState::kKept;
    arrivals_.resize(is_kept ? std::min<std::size_t>(arrivals_.size(), 1) : 0);
    arrivals_.push_back(field_.truth->at(began_at_));
    field_.recording.all();
    core::deliverQueuedEvents();
    const bool impatient = std::bernoulli_distribution(kPartOfImpatientShots)(random_);
    if (impatient) {
        field_.pass(500ms);
        if (field_.recording.isBusy()) {
            const auto shot_began_at = began_at_;
            askForAMove();
            began_at_ = shot_began_at;
            ++tally_.impatient;
        }
    }
    const auto all_ended = [this] { return !field_.recording.isBusy() && !field_.targeting.isMoving(); };
    if (!field_.until(all_ended, kLongestAction)) {
        ++tally_.deadlocks;
        complain("a record, or the move behind it, did not end", last_word_);
        return false;
    }
    if (impatient && field_.targeting.target() && field_.targeting.target()->state != app::MoveState::kArrived) {
        judgeMove();
    }
    if (own_records_ > before) {
        ++tally_.recorded;
        return true;
    }
    failed(field_.recording.readings().sentence);
    return false;
}

void Surveyor::failed(const QString& sentence) {
    faults_.standing().look(field_.time.now());
    const QString said = sentence.isEmpty() && last_word_at_ >= began_at_ ? last_word_ : sentence;
    const geometry::Pointing aimed = arrivals_.empty() ? field_.truth->at(field_.time.now()) : arrivals_.back();
    const bool natural = !field_.scene->echo(aimed).has_value() && said.contains(QStringLiteral("No distance came back"));
    ++tally_.refused[said.toStdString()];
    if (said.isEmpty() || (!natural && !faults_.standing().explain(said, began_at_))) {
        ++tally_.unexplained;
        complain("a failure without a reason", QStringLiteral("\"%1\" while there was: %2")
                                                   .arg(said, QString::fromStdString(faults_.standing().names(began_at_))));
    }
}

/// Mostly it is taken over.
void Surveyor::considerBlock() {
    // A late answer to RG is offered as well: then the telescope stands where it says.
    const auto pressed = field_.pressedWithin(2s);
    offered_at_ = pressed ? pressed : std::optional(field_.truth->at(field_.time.now()));
    if (std::bernoulli_distribution(kPartOfAcceptedBlocks)(random_)) {
        field_.recording.acceptBlock();
    } else {
        field_.recording.dismissBlock();
    }
}

void Surveyor::demandWork() {
    faults_.calm();
    field_.pass(1min);
    const bool is_back = field_.until([this] { return field_.isConnected() && !field_.instrument.isBusy(); }, 10min);
    bool has_worked = false;
    for (int i = 0; is_back && !has_worked && i < 5; ++i) {
        has_worked = turn() && record();  // a target on the black panel gives no distance
    }
    if (!has_worked) {
        ++tally_.deadlocks;
        complain("no way back to work", field_.instrument.connectionSentence() + u' ' + last_word_);
    }
    demandPictures();
    faults_.start();
}

/// The gate is open when nothing time-critical runs, and pictures come.
void Surveyor::demandPictures() {
    const auto before = field_.camera->shown();
    field_.pass(10s);
    if (field_.camera->shown() < before + 8) {
        ++tally_.deadlocks;
        complain("the video stands still", QString::number(field_.gate().statistics().pauses));
    }
}

/// Where the telescope pointed when the shot was made: a shot that was kept comes before the one of this arrival.
geometry::Pointing Surveyor::truthAtShot() {
    if (arrivals_.empty()) {
        return field_.truth->at(field_.time.now());
    }
    const geometry::Pointing oldest = arrivals_.front();
    arrivals_.pop_front();
    return oldest;
}

void Surveyor::check(const survey::Point& point) {
    recorded_.push_back(point);
    if (point.observation.source != u"pmts") {
        return checkBlock(point);
    }
    ++own_records_;
    const geometry::Pointing truth = truthAtShot();
    const auto echo = field_.scene->echo(truth);
    const QString wrong = wrongIn(point, {truth, echo ? std::optional(echo->distance_m) : std::nullopt}, field_.station_page.station());
    if (!wrong.isEmpty()) {
        ++tally_.wrong;
        complain("a wrong record", wrong);
    }
}

/// The same as its block, and the block as it was when REG was pressed.
void Surveyor::checkBlock(const survey::Point& point) {
    ++tally_.blocks;
    QString wrong = wrongOfBlock(point);
    if (wrong.isEmpty() && offered_at_) {
        const auto echo = field_.scene->echo(*offered_at_);
        wrong = wrongIn(point, {*offered_at_, echo ? std::optional(echo->distance_m) : std::nullopt}, field_.station_page.station());
    }
    if (!wrong.isEmpty()) {
        ++tally_.wrong;
        complain("a wrong record of a block", wrong);
    }
}

void Surveyor::compareWithFile() {
    std::vector<survey::Point> stored;
    const auto opened = QObject::connect(&field_.job, &app::JobDesk::opened, &field_.recording,
                                         [&stored](const app::JobContents& contents) { stored = contents.points; });
    field_.job.close();
    field_.job.open(field_.jobPath());
    const bool is_open = field_.until([&] { return !stored.empty() || recorded_.empty(); }, 1min);
    QObject::disconnect(opened);
    for (const survey::Point& point : recorded_) {
        const auto found = std::ranges::find(stored, point.row_id, &survey::Point::row_id);
        const bool same = found != stored.end() && found->id == point.id &&
                          found->observation.slope_distance_m == point.observation.slope_distance_m &&
                          found->observation.pointing == point.observation.pointing;
        if (!is_open || !same) {
            ++tally_.lost;
            complain("not in the job as it was acknowledged", point.id);
        }
    }
    if (stored.size() != recorded_.size()) {
        tally_.lost += stored.size() > recorded_.size() ? stored.size() - recorded_.size() : 0;
        complain("points in the job", QStringLiteral("%1, acknowledged %2").arg(stored.size()).arg(recorded_.size()));
    }
}

/// The files are read back whole, and the answer of each recorded point is in them.
void Surveyor::compareWithBlackBox() {
    field_.black_box.waitUntilWritten();
    QByteArray heard;
    std::size_t damaged = 0, lost = 0;
    for (const QString& path : blackbox::recordingsIn(field_.blackBoxFolder())) {
        const auto recording = blackbox::Recording::open(path);
        damaged += recording ? (*recording)->damages().size() : 1;
        for (const blackbox::Entry& entry : recording ? (*recording)->entries() : std::vector<blackbox::Entry>()) {
            lost += entry.kind == blackbox::Kind::kLost ? 1 : 0;
            const QCborMap map = entry.kind == blackbox::Kind::kBytes ? (*recording)->body(entry) : QCborMap();
            if (map.value(QStringLiteral("dir")).toString() == u"<") {
                heard += map.value(QStringLiteral("bytes")).toByteArray();
            }
        }
    }
    if (damaged + lost > 0) {
        tally_.lost += damaged + lost;
        complain("the black box", QStringLiteral("%1 damaged places, %2 times records were lost").arg(damaged).arg(lost));
    }
    qsizetype at = 0;
    for (std::size_t i = boxed_from_.value_or(recorded_.size()); i < recorded_.size(); ++i) {
        const auto found = heard.indexOf(recorded_[i].observation.raw_reply.toLatin1(), at);
        if (found < 0) {
            ++tally_.lost;
            complain("not in the black box", recorded_[i].observation.raw_reply);
        }
        at = std::max(at, found);
    }
    std::printf("black box: %lld bytes of the instrument, %zu points found in them\n", static_cast<long long>(heard.size()),
                recorded_.size() - boxed_from_.value_or(recorded_.size()));
}

void Surveyor::complain(const char* what, const QString& details) {
    std::fprintf(stderr, "soak: %.1f h: %s: %s\n", std::chrono::duration<double>(field_.time.now()).count() / 3600.0, what,
                 details.toUtf8().constData());
}

}  // namespace pmts::soak
