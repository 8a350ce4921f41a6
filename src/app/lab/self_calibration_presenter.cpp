#include "pmts/app/lab/self_calibration_presenter.hpp"

#include "pmts/calibration/sweep_plan.hpp"
#include "pmts/camera/scaled_rig.hpp"
#include "pmts/geometry/polar.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::app {

namespace {

constexpr int kMostPointings = 60;     ///< of all spots together
constexpr int kFirstPointings = 36;    ///< scouting included
constexpr int kFurtherPointings = 24;  ///< of a second spot: the lens is known by then
constexpr int kLeastPointings = 8;     ///< fewer tell nothing of a further spot
constexpr double kScoutRadius_px = 60.0;
constexpr double kSearchRadius_px = 30.0;  ///< the camera is known roughly by then

QString timeText(int seconds) {
    return seconds < 60 ? SelfCalibrationPresenter::tr("%1 s").arg(seconds)
                        : SelfCalibrationPresenter::tr("%1 min %2 s").arg(seconds / 60).arg(seconds % 60);
}

}  // namespace

SelfCalibrationPresenter::SelfCalibrationPresenter(LivePresenter& live, InstrumentDesk& instrument,
                                                   Preferences& preferences, MessageCentre& messages,
                                                   Threading threading, QObject* parent)
    : QObject(parent),
      live_(live),
      instrument_(instrument),
      preferences_(preferences),
      messages_(messages),
      threading_(threading),
      on_handle_(live.model().rig().mount.kind == camera::MountKind::kHandle) {
    connect(&instrument_, &InstrumentDesk::sweepStepped, this, &SelfCalibrationPresenter::onStep);
    connect(&instrument_, &InstrumentDesk::swept, this, &SelfCalibrationPresenter::onSwept);
    connect(&instrument_, &InstrumentDesk::turned, this,
            [this](Ticket ticket, const geometry::Pointing&) { onTurned(ticket); });
    connect(&instrument_, &InstrumentDesk::distanceMeasured, this,
            [this](Ticket ticket, const instrument::DistanceShot& shot) { onShot(ticket, shot.slope_distance_m); });
    connect(&instrument_, &InstrumentDesk::requestFailed, this, &SelfCalibrationPresenter::onFailed);
    connect(&watcher_, &QFutureWatcherBase::finished, this, &SelfCalibrationPresenter::finishSolving);
    connect(&preferences_, &Preferences::unitsChanged, this, &SelfCalibrationPresenter::show);
}

SelfCalibrationPresenter::~SelfCalibrationPresenter() {
    watcher_.disconnect(this);
    watcher_.cancel();
    watcher_.waitForFinished();
}

bool SelfCalibrationPresenter::isBusy() const {
    return phase_ == SelfCalibrationPhase::kSweeping || phase_ == SelfCalibrationPhase::kMeasuring ||
           phase_ == SelfCalibrationPhase::kSolving;
}

DeviceState SelfCalibrationPresenter::state() const {
    if (isBusy()) {
        return DeviceState::kBusy;
    }
    if (phase_ != SelfCalibrationPhase::kSolved || !found_) {
        return DeviceState::kIdle;
    }
    return found_->held_out_px <= 0.1 ? DeviceState::kGood : DeviceState::kWarning;
}

QString SelfCalibrationPresenter::step() const {
    switch (phase_) {
        case SelfCalibrationPhase::kPick:
            return tr("Click a sharp spot near the middle of the live view, 10 to 40 m away, with nothing similar near it.");
        case SelfCalibrationPhase::kReady:
            if (spots_.empty()) {
                return tr("Calibrate turns the instrument through about %1 pointings in both faces.").arg(kFirstPointings);
            }
            return hasRoomForASpot()
                       ? tr("Add this spot, at half the range of the first or less, or calibrate anew with it alone.")
                       : tr("The %1 pointings of this calibration are used: calibrate anew with this spot alone.").arg(kMostPointings);
        case SelfCalibrationPhase::kSweeping:
            return tr("The instrument sweeps the spot over the picture. Keep clear of it.");
        case SelfCalibrationPhase::kMeasuring:
            return tr("The distance of the spot is being measured.");
        case SelfCalibrationPhase::kSolving:
            return tr("The camera is being solved.");
        case SelfCalibrationPhase::kSolved:
            return hasRoomForASpot()
                       ? tr("Accept keeps this calibration with the camera. A click on a nearer spot adds a second range.")
                       : tr("Accept keeps this calibration with the camera.");
    }
    return {};
}

bool SelfCalibrationPresenter::hasRoomForASpot() const { return kMostPointings - pointings_used_ >= kLeastPointings; }

std::optional<QPointF> SelfCalibrationPresenter::spotPx() const {
    const auto& at = live_.scene().pointing;
    if (!picked_ || !at || isBusy()) {
        return std::nullopt;
    }
    const auto place = live_.model().pointingForPixel(picked_->click.px, picked_->click.at, picked_->click.slope_distance_m);
    const auto px = place ? live_.model().pixelForPoint(
                                geometry::stationFromPolar({*place, picked_->click.slope_distance_m}), *at)
                          : core::Result<Eigen::Vector2d>(tl::unexpected(place.error()));
    return px ? std::optional(QPointF(px->x(), px->y())) : std::nullopt;
}

void SelfCalibrationPresenter::setPhase(SelfCalibrationPhase phase) {
    phase_ = phase;
    Q_EMIT changed();
}

void SelfCalibrationPresenter::refuse(const QString& sentence) { Q_EMIT refused(sentence); }

bool SelfCalibrationPresenter::pickSpot(const QPointF& frame_px) {
    const LiveScene& scene = live_.scene();
    if (isBusy()) {
        refuse(tr("The instrument sweeps. Cancel first to pick another spot."));
        return false;
    }
    if (!scene.frame || !scene.pointing) {
        refuse(tr("There is no picture with circle readings yet. Connect the instrument and the camera."));
        return false;
    }
    if (scene.moving || instrument_.isTurning()) {
        refuse(tr("The telescope moves. Wait until it stands still, then click the spot."));
        return false;
    }
    picked_ = Picked{{.frame = scene.frame,
                      .at = *scene.pointing,
                      .px = {frame_px.x(), frame_px.y()},
                      .slope_distance_m = scene.range.slope_distance_m},
                     *scene.pointing};
    setPhase(SelfCalibrationPhase::kReady);
    return true;
}

void SelfCalibrationPresenter::setMeasuresRange(bool on) { measures_range_ = on; }

void SelfCalibrationPresenter::setSighted(bool on) { is_sighted_ = on; }

void SelfCalibrationPresenter::setOnHandle(bool on) { on_handle_ = on; }

/// The rig in use, in the size of the picture, with a lens that a fit can start from.
camera::Rig SelfCalibrationPresenter::startRig() const {
    camera::Rig rig = live_.model().rig();
    const cv::Mat& image = picked_->click.frame->image;
    if (image.cols != rig.width_px || image.rows != rig.height_px) {
        rig = camera::scaledRig(rig, image.cols, image.rows);
    }
    if (!std::holds_alternative<camera::BrownLens>(rig.lens.model())) {
        rig.lens = camera::Lens(camera::BrownLens{.f_px = rig.lens.focalLengthPx(),
                                                  .cx_px = rig.lens.principalPoint().x(),
                                                  .cy_px = rig.lens.principalPoint().y()});
    }
    rig.lens = rig.lens.withResiduals(std::nullopt);
    rig.mount.kind = on_handle_ ? camera::MountKind::kHandle : camera::MountKind::kTelescope;
    return rig;
}

geometry::PolarPoint SelfCalibrationPresenter::believedPlace() const {
    const targeting::Click& click = picked_->click;
    if (is_sighted_) {
        return {picked_->cross_hair, click.slope_distance_m};
    }
    const auto at = targeting::PixelToPointing(rough_).pointingForPixel(click.px, click.at, click.slope_distance_m);
    return {at.value_or(click.at), click.slope_distance_m};
}

void SelfCalibrationPresenter::calibrate(bool further) {
    if (isBusy()) {
        return;
    }
    if (!picked_) {
        refuse(step());
        return;
    }
    if (instrument_.connectionState() != ConnectionState::kConnected) {
        refuse(tr("The instrument is not connected: it must turn for this."));
        return;
    }
    if (further && !spots_.empty() && !hasRoomForASpot()) {
        picked_.reset();
        setPhase(SelfCalibrationPhase::kSolved);
        return refuse(tr("The %1 pointings of this calibration are used. Accept it, or click a spot and calibrate anew.")
                          .arg(kMostPointings));
    }
    if (!further || spots_.empty()) {
        spots_.clear();
        pointings_used_ = 0;
        found_.reset();
        view_.reset();
        start_ = rough_ = startRig();
    }
    sweeping_ = {.about = {}, .range_measured = false, .direction_sighted = is_sighted_, .pictures = {}};
    // What is known from the first spot needs no scouting for the second.
    stage_ = spots_.empty() ? 0 : calibration::kScoutingStages;
    pointings_left_ = spots_.empty() ? kFirstPointings : std::min(kFurtherPointings, kMostPointings - pointings_used_);
    seen_.clear();
    done_before_ = 0;
    progress_ = {.done = 0, .of = pointings_left_, .missed = 0, .seconds_left = 0, .sentence = {}};
    setPhase(SelfCalibrationPhase::kSweeping);
    sweepStage();
}

void SelfCalibrationPresenter::sweepStage() {
    sweeping_.about = believedPlace();
    const bool scouts = stage_ < calibration::kScoutingStages;
    const auto options =
        scouts ? calibration::scouting(stage_) : calibration::SweepPlanOptions{.most_pointings = pointings_left_};
    auto plan = calibration::planSweep(rough_, geometry::stationFromPolar(sweeping_.about), options);
    if (!plan) {
        return fail(plan.error());
    }
    pointings_left_ -= static_cast<int>(plan->pointings.size());
    seconds_each_ = std::chrono::duration<double>(plan->instrument_time).count() /
                    static_cast<double>(plan->pointings.size());
    if (!scouts) {
        progress_.of = done_before_ + static_cast<int>(plan->pointings.size());
    }
    tellProgress(0, seconds_each_);
    SweepOrder order{.click = picked_->click,
                     .pointings = plan->pointings,
                     .model = targeting::PixelToPointing(rough_),
                     .frames = live_.feed(),
                     .settings = {},
                     .seen_before = seen_};
    order.settings.search_radius_px = scouts ? kScoutRadius_px : kSearchRadius_px;
    order.settings.come_back = !scouts;
    ticket_ = instrument_.sweep(order);
}

void SelfCalibrationPresenter::tellProgress(int done_in_stage, double seconds_each) {
    progress_.done = done_before_ + done_in_stage;
    progress_.seconds_left = static_cast<int>(std::ceil((progress_.of - progress_.done) * seconds_each));
    progress_.sentence = tr("Pointing %1 of %2, about %3 left")
                             .arg(std::min(progress_.done + 1, progress_.of))
                             .arg(progress_.of)
                             .arg(timeText(progress_.seconds_left));
    if (progress_.missed > 0) {
        progress_.sentence += tr(", %1 without the spot").arg(progress_.missed);
    }
    Q_EMIT progressChanged();
}

void SelfCalibrationPresenter::onStep(Ticket ticket, const targeting::SweepStep& step) {
    if (ticket != ticket_ || phase_ != SelfCalibrationPhase::kSweeping) {
        return;
    }
    progress_.missed += step.missed ? 1 : 0;
    tellProgress(static_cast<int>(step.done), seconds_each_);
}

void SelfCalibrationPresenter::onSwept(Ticket ticket, const targeting::SweepOutcome& outcome) {
    if (ticket != ticket_ || phase_ != SelfCalibrationPhase::kSweeping) {
        return;
    }
    for (const targeting::SpotSighting& sighting : outcome.sightings) {
        sweeping_.pictures.push_back({sighting.at, sighting.px});
    }
    seen_.insert(seen_.end(), outcome.sightings.begin(), outcome.sightings.end());
    done_before_ += static_cast<int>(outcome.sightings.size() + outcome.missed.size());
    auto all = spots_;
    all.push_back(sweeping_);
    rough_ = calibration::roughRig(all, start_).value_or(rough_);
    if (++stage_ <= calibration::kScoutingStages) {
        return sweepStage();
    }
    afterSweep();
}

void SelfCalibrationPresenter::afterSweep() {
    seen_.clear();
    if (!measures_range_) {
        keepSpot();
        return solve();
    }
    setPhase(SelfCalibrationPhase::kMeasuring);
    ticket_ = instrument_.turnTo(believedPlace().pointing, core::Angle::fromCc(10));
}

void SelfCalibrationPresenter::keepSpot() {
    spots_.push_back(sweeping_);
    pointings_used_ += done_before_;
}

void SelfCalibrationPresenter::onTurned(Ticket ticket) {
    if (ticket == ticket_ && phase_ == SelfCalibrationPhase::kMeasuring) {
        ticket_ = instrument_.measureDistance();
    }
}

void SelfCalibrationPresenter::onShot(Ticket ticket, double slope_distance_m) {
    if (ticket != ticket_ || phase_ != SelfCalibrationPhase::kMeasuring) {
        return;
    }
    sweeping_.about.slope_distance_m = slope_distance_m;
    sweeping_.range_measured = true;
    keepSpot();
    solve();
}

void SelfCalibrationPresenter::onFailed(Ticket ticket, const core::Error& error) {
    if (ticket != ticket_ || !isBusy()) {
        return;
    }
    if (phase_ == SelfCalibrationPhase::kMeasuring && error.kind != core::ErrorKind::kCancelled) {
        messages_.warn(tr("The distance of the spot could not be measured: %1").arg(error.happened),
                       tr("The offsets keep their values; everything else is solved."));
        keepSpot();
        return solve();
    }
    fail(error);
}

void SelfCalibrationPresenter::fail(const core::Error& error) {
    ticket_ = 0;
    if (error.kind != core::ErrorKind::kCancelled) {
        messages_.report(error);
    }
    setPhase(found_ ? SelfCalibrationPhase::kSolved : picked_ ? SelfCalibrationPhase::kReady : SelfCalibrationPhase::kPick);
    refuse(error.kind == core::ErrorKind::kCancelled ? tr("Cancelled. Nothing was changed.") : error.sentence());
}

void SelfCalibrationPresenter::cancel() {
    if (phase_ == SelfCalibrationPhase::kSolving) {
        watcher_.cancel();
    } else if (isBusy()) {
        instrument_.cancel(ticket_);
    }
}

}  // namespace pmts::app
