#include "pmts/app/lab/check_presenter.hpp"

#include "field/spot_at.hpp"
#include "pmts/geometry/polar.hpp"
#include "pmts/targeting/bring_pixel.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pmts::app {

namespace {

constexpr std::size_t kFewest = 3;  ///< sightings that make a check
constexpr double kReach = 0.6;      ///< of the half picture, towards its corners
/// A click this far off still means the spot; a window so small that nobody waits for it.
constexpr targeting::SnapSettings kSnap{.radius_px = 8.0, .largest_half_axis_px = 15.0};

Eigen::Vector2d vectorOf(const QPointF& px) { return {px.x(), px.y()}; }

double rmsOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value * value;
    }
    return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

CheckPresenter::CheckPresenter(LivePresenter& live, InstrumentDesk& instrument, const PointsModel& points, Preferences& preferences,
                               ProfilesPresenter& profiles, const core::Clock& clock, QObject* parent)
    : QObject(parent), live_(live), instrument_(instrument), points_(points), preferences_(preferences), profiles_(profiles),
      clock_(clock) {
    connect(&instrument_, &InstrumentDesk::sweepStepped, this, [this](Ticket ticket, const targeting::SweepStep& step) {
        if (ticket == ticket_ && stage_ == CheckStage::kRunning) {
            done_ = step.done;
            Q_EMIT changed();
        }
    });
    connect(&instrument_, &InstrumentDesk::swept, this, [this](Ticket ticket, const targeting::SweepOutcome& outcome) {
        if (ticket != ticket_ || stage_ != CheckStage::kRunning) {
            return;
        }
        for (const targeting::SpotSighting& sighting : outcome.sightings) {
            add(sighting.at, sighting.px);
        }
        if (running_.residuals.size() < kFewest) {
            stage_ = CheckStage::kReady;
            return setTrouble(outcome.missed.empty() ? tr("The spot was seen too seldom.")
                                                     : outcome.missed.front().reason.sentence());
        }
        judge();
    });
    connect(&instrument_, &InstrumentDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == ticket_ && stage_ == CheckStage::kRunning) {
            stage_ = CheckStage::kReady;
            setTrouble(error.sentence());
        }
    });
}

QString CheckPresenter::step() const {
    switch (stage_) {
        case CheckStage::kIdle:
            return !place_ ? tr("Choose a recorded point, or point the telescope at a spot and measure it.")
                           : tr("Click %1 in the live view: the click jumps to the corner or mark beside it.").arg(place_->name);
        case CheckStage::kReady:
            return is_snapped_ ? tr("Start: the telescope turns through five pointings and comes back.")
                               : tr("No corner or mark is beside the click, so it counts as it is: zoom in and click to the "
                                    "pixel, or start.");
        case CheckStage::kRunning: return tr("Looking: %1 of %2.").arg(done_).arg(pointings_.size());
        case CheckStage::kDone: return verdict();
    }
    return {};
}

void CheckPresenter::setTrouble(const QString& sentence) {
    trouble_ = sentence;
    Q_EMIT changed();
}

void CheckPresenter::usePoint(qint64 row_id) {
    const auto place = live_.placeOf(OverlayKind::kPoint, row_id);
    const survey::Point* const point = points_.find(row_id);
    if (!place || !point) {
        return setTrouble(tr("That point has no coordinates at this station."));
    }
    place_ = KnownPlace{.p_station = place->p_station, .name = tr("point %1").arg(point->id)};
    clicked_px_.reset();
    stage_ = CheckStage::kIdle;
    setTrouble({});
}

void CheckPresenter::useTelescope() {
    const auto newest = instrument_.track().newest();
    const RangeAssumption range = newest ? live_.rangeFor(newest->pointing) : RangeAssumption{};
    if (!newest || range.source != RangeSource::kMeasured) {
        return setTrouble(tr("Point the telescope at a spot that looks the same from every side and measure its distance (D)."));
    }
    place_ = KnownPlace{.p_station = geometry::stationFromPolar({.pointing = newest->pointing, .slope_distance_m = range.slope_distance_m}),
                        .name = tr("the spot under the telescope")};
    clicked_px_.reset();
    stage_ = CheckStage::kIdle;
    setTrouble({});
}

bool CheckPresenter::standsStill() const { return live_.scene().frame && live_.scene().pointing && !live_.scene().moving; }

void CheckPresenter::click(const QPointF& live_px) {
    if (stage_ == CheckStage::kRunning || !place_) {
        return;
    }
    if (!standsStill()) {
        return setTrouble(tr("The telescope moves. Wait until it stands still, then click again."));
    }
    clicked_frame_ = live_.scene().frame;
    const Eigen::Vector2d spot = spotAt(clicked_frame_, vectorOf(live_px), kSnap);
    clicked_px_ = QPointF(spot.x(), spot.y());
    is_snapped_ = *clicked_px_ != live_px;
    clicked_at_ = live_.scene().pointing;
    stage_ = CheckStage::kReady;
    setTrouble({});
}

std::vector<Eigen::Vector2d> CheckPresenter::placesInPicture() const {
    const camera::Rig& rig = live_.model().rig();
    const Eigen::Vector2d half((rig.width_px - 1) / 2.0, (rig.height_px - 1) / 2.0);
    std::vector<Eigen::Vector2d> places{half};
    for (const Eigen::Vector2d& side : {Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, -1), Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1)}) {
        places.push_back(half + kReach * half.cwiseProduct(side));
    }
    return places;
}

void CheckPresenter::run() {
    if (stage_ != CheckStage::kReady && stage_ != CheckStage::kDone) {
        return setTrouble(step());
    }
    if (!clicked_px_ || !clicked_at_ || !place_) {
        return setTrouble(tr("Click the spot in the live view first."));
    }
    const double range_m = place_->p_station.norm();
    pointings_.clear();
    for (const Eigen::Vector2d& px : placesInPicture()) {
        if (const auto at = targeting::pointingToBring(live_.model(), vectorOf(*clicked_px_), px, *clicked_at_, range_m)) {
            pointings_.push_back(*at);
        }
    }
    done_ = 0;
    running_ = RigCheck{};
    angles_.clear();
    result_.reset();
    stage_ = CheckStage::kRunning;
    trouble_.clear();
    targeting::SweepSettings sweep;
    sweep.turn_tolerance = preferences_.settings().turn_tolerance;
    ticket_ = instrument_.sweep({.click = {.frame = clicked_frame_, .at = *clicked_at_, .px = vectorOf(*clicked_px_), .slope_distance_m = range_m},
                                 .pointings = pointings_,
                                 .model = live_.model(),
                                 .frames = live_.feed(),
                                 .settings = sweep});
    Q_EMIT changed();
}

void CheckPresenter::takeByHand() {
    if (!clicked_px_ || !clicked_at_ || !place_ || stage_ == CheckStage::kRunning) {
        return setTrouble(tr("Click the spot in the live view first."));
    }
    if (stage_ == CheckStage::kDone) {
        running_ = RigCheck{};
        angles_.clear();
        result_.reset();
    }
    add(*clicked_at_, vectorOf(*clicked_px_));
    clicked_px_.reset();
    stage_ = CheckStage::kIdle;
    trouble_.clear();
    if (running_.residuals.size() >= placesInPicture().size()) {
        return judge();
    }
    setTrouble(tr("%1 of %2 taken: turn the telescope, then click the spot again.").arg(running_.residuals.size()).arg(placesInPicture().size()));
}

void CheckPresenter::cancel() {
    if (stage_ == CheckStage::kRunning) {
        instrument_.cancel(ticket_);
    }
}

void CheckPresenter::add(const geometry::Pointing& at, const Eigen::Vector2d& px) {
    const auto predicted = live_.model().pixelForPoint(place_->p_station, at);
    const auto ray = live_.model().rayForPixel(px, at);
    if (!predicted || !ray) {
        return;
    }
    running_.residuals.push_back({.px = px, .residual_px = *predicted - px});
    const Eigen::Vector3d towards = (place_->p_station - ray->origin_m).normalized();
    angles_.push_back(core::Angle::fromRad(std::atan2(towards.cross(ray->direction).norm(), towards.dot(ray->direction))));
}

void CheckPresenter::judge() {
    const RigCareSettings& care = preferences_.settings().rig_care;
    std::vector<double> lengths_px;
    std::vector<double> angles_rad;
    for (std::size_t i = 0; i < running_.residuals.size(); ++i) {
        lengths_px.push_back(running_.residuals[i].residual_px.norm());
        angles_rad.push_back(angles_[i].rad());
    }
    running_.utc = clock_.utcNow();
    running_.pointings = static_cast<int>(lengths_px.size());
    running_.rms_px = rmsOf(lengths_px);
    running_.largest_px = *std::max_element(lengths_px.begin(), lengths_px.end());
    running_.rms = core::Angle::fromRad(rmsOf(angles_rad));
    running_.largest = core::Angle::fromRad(*std::max_element(angles_rad.begin(), angles_rad.end()));
    running_.limit_px = care.check_limit_px;
    running_.limit = care.check_limit;
    running_.passed = running_.rms_px <= care.check_limit_px && running_.rms <= care.check_limit;
    running_.target = place_->name;
    running_.temperature_c = profiles_.temperature();
    result_ = running_;
    running_ = RigCheck{};
    angles_.clear();
    stage_ = CheckStage::kDone;
    trouble_.clear();
    preferences_.keepCheck(live_.rigChoice().profile.name, *result_);
    Q_EMIT changed();
    Q_EMIT finished(*result_);
}

QString CheckPresenter::verdict() const {
    if (!result_) {
        return {};
    }
    const QString numbers = tr("%1 px, %2 mgon rms (limits %3 px, %4 mgon)").arg(result_->rms_px, 0, 'f', 2).arg(result_->rms.gon() * 1000, 0, 'f', 1)
                                .arg(result_->limit_px, 0, 'f', 2).arg(result_->limit.gon() * 1000, 0, 'f', 0);
    return result_->passed ? tr("Passed: %1.").arg(numbers) : tr("Failed: %1. Calibrate the camera again.").arg(numbers);
}

}  // namespace pmts::app
