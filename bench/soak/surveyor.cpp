#include "surveyor.hpp"

#include <cmath>
#include <cstdio>

namespace pmts::soak {
namespace {

using namespace std::chrono_literals;
using core::Angle;

constexpr core::Duration kLongestAction = 15min;  ///< the longest limits of driver and reconnecting together are shorter
constexpr core::Duration kAftermath = 15min;      ///< so long a trouble may be the reason of a failure
constexpr double kDistanceBand_m = 5 * 0.0032;    ///< five sigma: 3 mm and 3 ppm
constexpr double kCircleBand_cc = 16;             ///< five sigma of 3 cc
constexpr double kCoordinateBand_m = 1e-6;        ///< the same formula twice

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
}

void Surveyor::work(core::Duration span) {
    const core::Duration end = field_.time.now() + span;
    core::Duration next_calm = field_.time.now() + 4h;
    faults_.start();
    while (field_.time.now() < end && tally_.deadlocks == 0) {
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
}

/// One minute in the mean: walking, writing, looking.
void Surveyor::rest() { field_.pass(std::chrono::seconds(std::uniform_int_distribution(5, 90)(random_))); }

bool Surveyor::turn() {
    const double ha_gon = std::uniform_real_distribution(-50.0, 130.0)(random_);
    const double va_gon = std::uniform_real_distribution(85.0, 115.0)(random_);
    began_at_ = field_.time.now();
    field_.targeting.aimAtText(QStringLiteral("%1 gon").arg(ha_gon), QStringLiteral("%1 gon").arg(va_gon));
    field_.targeting.move();
    if (!field_.until([this] { return !field_.targeting.isMoving(); }, kLongestAction)) {
        ++tally_.deadlocks;
        complain("a move did not end", last_word_);
        return false;
    }
    if (field_.targeting.target() && field_.targeting.target()->state == app::MoveState::kArrived) {
        ++tally_.turned;
        return true;
    }
    const bool was_tried = field_.targeting.target() && field_.targeting.target()->state != app::MoveState::kAimed;
    failed(was_tried ? field_.targeting.target()->sentence : QString());
    return false;
}

bool Surveyor::record() {
    const std::size_t before = recorded_.size();
    began_at_ = field_.time.now();
    const bool is_kept = field_.recording.readings().shot == app::ShotState::kKept;
    arrivals_.resize(is_kept ? std::min<std::size_t>(arrivals_.size(), 1) : 0);
    arrivals_.push_back(field_.truth->at(began_at_));
    field_.recording.all();
    core::deliverQueuedEvents();
    if (!field_.until([this] { return !field_.recording.isBusy(); }, kLongestAction)) {
        ++tally_.deadlocks;
        complain("a record did not end", last_word_);
        return false;
    }
    if (recorded_.size() > before) {
        ++tally_.recorded;
        return true;
    }
    failed(field_.recording.readings().sentence);
    return false;
}

void Surveyor::failed(const QString& sentence) {
    const QString said = sentence.isEmpty() && last_word_at_ >= began_at_ ? last_word_ : sentence;
    const auto echo = field_.scene->echo(field_.truth->at(field_.time.now()));
    const bool natural = !echo.has_value();
    const bool provoked = natural || (faults_.count() > 0 && field_.time.now() - faults_.latest() < kAftermath);
    ++tally_.refused[said.toStdString()];
    if (said.isEmpty() || !provoked) {
        ++tally_.unexplained;
        complain("a failure without a reason", said);
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
    faults_.start();
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

/// Against the simulator's truth, and E, N, H by the plain polar formula (N = cos).
void Surveyor::check(const survey::Point& point) {
    recorded_.push_back(point);
    if (point.observation.source != u"pmts") {
        return;
    }
    const geometry::Pointing truth = truthAtShot();
    const auto echo = field_.scene->echo(truth);
    const double sd_m = point.observation.slope_distance_m.value_or(0.0);
    const Angle off_ha = core::normalizedSigned(point.observation.pointing.ha - truth.ha);
    const Angle off_va = core::normalizedSigned(point.observation.pointing.va - truth.va);
    const double ha = point.observation.pointing.ha.rad(), va = point.observation.pointing.va.rad();
    const survey::Station& station = field_.station_page.station();
    const double bearing = ha + station.orientation.rad();
    const double off_enh_m = std::hypot(point.coordinates.e_m - (station.e_m + sd_m * std::sin(va) * std::sin(bearing)),
                                        point.coordinates.n_m - (station.n_m + sd_m * std::sin(va) * std::cos(bearing)),
                                        point.coordinates.h_m - (station.h_m + station.instrument_height_m -
                                                                 point.observation.target_height_m + sd_m * std::cos(va)));
    const bool right = echo && std::abs(sd_m - echo->distance_m) <= kDistanceBand_m &&
                       std::abs(off_ha.cc()) <= kCircleBand_cc && std::abs(off_va.cc()) <= kCircleBand_cc &&
                       off_enh_m <= kCoordinateBand_m;
    if (!right) {
        ++tally_.wrong;
        complain("a wrong record", QStringLiteral("SD %1 m instead of %2 m, HA off %3 cc, VA off %4 cc, ENH off %5 m: %6")
                                       .arg(sd_m).arg(echo ? echo->distance_m : 0.0).arg(off_ha.cc()).arg(off_va.cc())
                                       .arg(off_enh_m).arg(point.observation.raw_reply));
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

void Surveyor::complain(const char* what, const QString& details) {
    std::fprintf(stderr, "soak: %.1f h: %s: %s\n", std::chrono::duration<double>(field_.time.now()).count() / 3600.0, what,
                 details.toUtf8().constData());
}

}  // namespace pmts::soak
