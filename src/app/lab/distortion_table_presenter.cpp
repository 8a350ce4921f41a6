#include "pmts/app/lab/distortion_table_presenter.hpp"

#include "pmts/targeting/bring_pixel.hpp"
#include "field/spot_at.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::app {

namespace {

using calibration::RadiusDirection;

constexpr double kMargin_px = 18.0;
constexpr double kSearch_px = 60.0;
constexpr std::size_t kLeastSpots = 3;

}  // namespace

DistortionTablePresenter::DistortionTablePresenter(LivePresenter& live, InstrumentDesk& instrument, const RangeKeeper& range,
                                                   Preferences& preferences, MessageCentre& messages, Threading threading,
                                                   QObject* parent)
    : QObject(parent), live_(live), instrument_(instrument), range_(range), preferences_(preferences), messages_(messages),
      threading_(threading) {
    connect(&instrument_, &InstrumentDesk::sweepStepped, this, [this](Ticket ticket, const targeting::SweepStep& step) {
        if (ticket == ticket_) {
            onStep(step);
        }
    });
    connect(&instrument_, &InstrumentDesk::swept, this, [this](Ticket ticket, const targeting::SweepOutcome& outcome) {
        if (ticket == ticket_) {
            ticket_ = 0;
            onSwept(outcome);
        }
    });
    connect(&instrument_, &InstrumentDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == ticket_) {
            ticket_ = 0;
            say(error.sentence());
        }
    });
}

DeviceState DistortionTablePresenter::state() const {
    if (isSweeping()) {
        return DeviceState::kBusy;
    }
    if (!trouble_.isEmpty() || (!rows_.empty() && !rowsTrouble().isEmpty())) {
        return DeviceState::kFailed;
    }
    if (is_accepted_) {
        return DeviceState::kGood;
    }
    return rows_.empty() ? DeviceState::kIdle : DeviceState::kWarning;
}

QString DistortionTablePresenter::step() const {
    if (isSweeping()) {
        return tr("The instrument leads the target along the radius: place %1 of %2.").arg(std::min(done_ + 1, of_)).arg(of_);
    }
    if (!trouble_.isEmpty()) {
        return trouble_;
    }
    if (is_accepted_) {
        return tr("The table is the lens of the rig now. Check it on a known point.");
    }
    if (by_hand_ && target_) {
        return tr("Turn until the target is on the next circle of the grid, then click it.");
    }
    if (target_) {
        return tr("Press Start: the instrument turns, the target steps through the picture.");
    }
    return rows_.empty() ? tr("Measure the distance to a sharp target, then click it in the picture.")
                         : tr("Press Accept, or click a target at another distance.");
}

QString DistortionTablePresenter::progressText() const {
    return isSweeping() || missed_ > 0 ? tr("%1 of %2 places, %3 missed").arg(done_).arg(of_).arg(missed_) : QString();
}

double DistortionTablePresenter::progress() const { return of_ == 0 ? 0.0 : static_cast<double>(done_) / static_cast<double>(of_); }

QString DistortionTablePresenter::targetText() const {
    return target_ ? rangeText({target_->place.slope_distance_m, target_->source}, preferences_.units()) : QStringLiteral("–");
}

QStringList DistortionTablePresenter::runTexts() const {
    QStringList texts;
    for (const calibration::TableRun& run : runs_) {
        texts.append(tr("%1, places: %2").arg(preferences_.units().length(run.target.slope_distance_m)).arg(run.spots.size()));
    }
    return texts;
}

std::vector<calibration::PlannedSpot> DistortionTablePresenter::grid() const {
    return calibration::plannedSpots(live_.model().rig(), directions_, step_px_, kMargin_px);
}

void DistortionTablePresenter::setStep(double step_px) {
    step_px_ = std::clamp(step_px, 5.0, 200.0);
    compute();
}

void DistortionTablePresenter::setDirections(const std::vector<RadiusDirection>& directions) {
    directions_ = directions;
    Q_EMIT changed();
}

void DistortionTablePresenter::setByHand(bool by_hand) {
    by_hand_ = by_hand;
    Q_EMIT changed();
}

// Measuring ---------------------------------------------------------------------------------------------------------

void DistortionTablePresenter::click(const QPointF& frame_px) {
    const LiveScene& scene = live_.scene();
    if (isSweeping()) {
        return;
    }
    if (!scene.frame || !scene.pointing || scene.moving) {
        return say(tr("Wait until the telescope stands still, then click."));
    }
    inPool(
        threading_, this, [frame = scene.frame, px = Eigen::Vector2d(frame_px.x(), frame_px.y())] { return spotAt(frame, px); },
        [this, frame = scene.frame, at = *scene.pointing](const Eigen::Vector2d& px) {
            by_hand_ && target_ ? addByHand(at, px) : choose(frame, at, px);
        });
}

void DistortionTablePresenter::choose(const camera::FramePtr& frame, const geometry::Pointing& at, const Eigen::Vector2d& px) {
    const RangeAssumption range = range_.rangeAt(at);
    const auto place = live_.model().pointingForPixel(px, at, range.slope_distance_m);
    if (!place) {
        return say(place.error().sentence());
    }
    target_ = Target{.frame = frame, .at = at, .px = px, .place = {*place, range.slope_distance_m}, .source = range.source};
    seen_px_ = {QPointF(px.x(), px.y())};
    missed_ = 0;
    is_accepted_ = false;
    if (by_hand_) {
        keepRun({.target = target_->place, .spots = {{px, at}}});
    }
    say({});
}

void DistortionTablePresenter::addByHand(const geometry::Pointing& at, const Eigen::Vector2d& px) {
    trouble_.clear();
    seen_px_.emplace_back(px.x(), px.y());
    runs_.back().spots.push_back({px, at});
    compute();
}

/// In the order of the grid; a place the instrument cannot bring the target to is left out.
std::vector<geometry::Pointing> DistortionTablePresenter::pointings() const {
    std::vector<geometry::Pointing> list;
    for (const calibration::PlannedSpot& spot : grid()) {
        const auto at =
            targeting::pointingToBring(live_.model(), target_->px, spot.px, target_->at, target_->place.slope_distance_m);
        if (at) {
            list.push_back(*at);
        }
    }
    return list;
}

void DistortionTablePresenter::start() {
    if (!canStart()) {
        return;
    }
    const std::vector<geometry::Pointing> list = pointings();
    if (list.size() < kLeastSpots) {
        return say(live_.model().rig().mount.kind == camera::MountKind::kHandle
                       ? tr("A camera on the handle sees the target move to the sides only: choose right or left.")
                       : tr("The instrument cannot bring the target to enough places of this radius."));
    }
    done_ = missed_ = 0;
    of_ = list.size();
    seen_px_.clear();
    targeting::SweepSettings settings;
    settings.turn_tolerance = preferences_.settings().turn_tolerance;
    settings.search_radius_px = kSearch_px;
    targeting::Click click;
    click.frame = target_->frame;
    click.at = target_->at;
    click.px = target_->px;
    click.slope_distance_m = target_->place.slope_distance_m;
    ticket_ = instrument_.sweep({.click = click, .pointings = list, .model = live_.model(), .frames = live_.feed(), .settings = settings});
    say({});
}

void DistortionTablePresenter::cancel() {
    if (isSweeping()) {
        instrument_.cancel(ticket_);
    }
}

void DistortionTablePresenter::onStep(const targeting::SweepStep& step) {
    done_ = step.done;
    of_ = step.of;
    missed_ += step.missed ? 1U : 0U;
    if (step.sighting) {
        seen_px_.emplace_back(step.sighting->px.x(), step.sighting->px.y());
    }
    Q_EMIT progressed();
}

void DistortionTablePresenter::onSwept(const targeting::SweepOutcome& outcome) {
    calibration::TableRun run{.target = target_->place, .spots = {}};
    for (const targeting::SpotSighting& sighting : outcome.sightings) {
        run.spots.push_back({sighting.px, sighting.at});
    }
    missed_ = outcome.missed.size();
    if (run.spots.size() < kLeastSpots) {
        return say(outcome.missed.empty() ? tr("The target was not found.") : outcome.missed.front().reason.sentence());
    }
    messages_.cue(Cue::kArrived);
    keepRun(run);
    target_.reset();
    say({});
}

void DistortionTablePresenter::keepRun(const calibration::TableRun& run) {
    runs_.push_back(run);
    is_edited_ = false;
    compute();
}

void DistortionTablePresenter::newTarget() {
    target_.reset();
    seen_px_.clear();
    say({});
}

void DistortionTablePresenter::removeRun(int index) {
    if (index >= 0 && index < static_cast<int>(runs_.size())) {
        runs_.erase(runs_.begin() + index);
        target_.reset();
        is_edited_ = false;
        compute();
    }
}

// Rows --------------------------------------------------------------------------------------------------------------

void DistortionTablePresenter::compute() {
    curves_.clear();
    trouble_.clear();
    for (const calibration::TableRun& run : runs_) {
        const auto curves = calibration::curvesOfRun(run, live_.model().rig());
        if (curves) {
            curves_.insert(curves_.end(), curves->begin(), curves->end());
        } else if (run.spots.size() >= kLeastSpots) {
            trouble_ = curves.error().sentence();
        }
    }
    if (!is_edited_) {
        rows_.clear();
        spread_rad_.clear();
        if (const auto table = calibration::tableOfCurves(curves_, centre(), step_px_)) {
            rows_ = table->lens.rows;
            spread_rad_ = table->spread_rad;
            table_centre_ = centre();
        }
    }
    is_accepted_ = false;
    Q_EMIT changed();
}

std::vector<TableRowText> DistortionTablePresenter::rows() const {
    const UnitFormat& units = preferences_.units();
    const double width_rad = calibration::centralPixelWidth_rad(rows_);
    std::vector<TableRowText> texts;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const double off_rad = rows_[i].angle_rad - calibration::idealLensAngle_rad(width_rad, rows_[i].radius_px);
        texts.push_back({.radius = QString::number(rows_[i].radius_px, 'f', 1),
                         .angle = units.angleNumber(core::Angle::fromRad(rows_[i].angle_rad)),
                         .deviation = units.angleNumber(core::Angle::fromRad(off_rad)),
                         .spread = i < spread_rad_.size() && curves_.size() > 1
                                       ? units.smallAngle(core::Angle::fromRad(spread_rad_[i]))
                                       : QString()});
    }
    return texts;
}

QString DistortionTablePresenter::rowsTrouble() const { return calibration::whyNoTable(rows_); }

bool DistortionTablePresenter::canAccept() const { return rows_.size() > 2 && rowsTrouble().isEmpty() && !isSweeping(); }

QString DistortionTablePresenter::summary() const {
    if (!canAccept()) {
        return {};
    }
    const UnitFormat& units = preferences_.units();
    const double width_rad = calibration::centralPixelWidth_rad(rows_);
    const Row& last = rows_.back();
    const double most_rad = spread_rad_.empty() ? 0.0 : *std::max_element(spread_rad_.begin(), spread_rad_.end());
    const QString edge = tr("f = %1 px. At pixel %2: %3 from the ideal lens, %4 from the straight line.")
                             .arg(1.0 / width_rad, 0, 'f', 1)
                             .arg(last.radius_px, 0, 'f', 0)
                             .arg(units.angle(core::Angle::fromRad(last.angle_rad - calibration::idealLensAngle_rad(width_rad, last.radius_px))),
                                  units.angle(core::Angle::fromRad(last.angle_rad - calibration::idealLineAngle_rad(width_rad, last.radius_px))));
    return curves_.size() > 1 ? edge + u' ' + tr("All %1 curves agree within %2.")
                                                  .arg(curves_.size())
                                                  .arg(units.smallAngle(core::Angle::fromRad(most_rad)))
                              : edge;
}

void DistortionTablePresenter::setRow(int row, const QString& radius_px, const QString& angle) {
    if (row < 1 || row >= static_cast<int>(rows_.size())) {
        return say(tr("The first row is the centre and stays."));
    }
    bool is_number = false;
    const double radius = QString(radius_px).replace(u',', u'.').toDouble(&is_number);
    const auto parsed = preferences_.units().parseAngle(angle);
    if (!is_number || !parsed) {
        return say(is_number ? parsed.error().sentence() : tr("“%1” is not a radius in pixels.").arg(radius_px));
    }
    rows_[static_cast<std::size_t>(row)] = {radius, parsed->rad()};
    is_edited_ = true;
    is_accepted_ = false;
    spread_rad_.clear();
    say({});
}

void DistortionTablePresenter::addRow() {
    if (rows_.empty()) {
        rows_ = {{0.0, 0.0}};
        table_centre_ = centre();
    }
    const Row last = rows_.back();
    const double slope = rows_.size() > 1 ? last.angle_rad / last.radius_px : 1.0 / live_.model().rig().lens.focalLengthPx();
    rows_.push_back({last.radius_px + step_px_, last.angle_rad + slope * step_px_});
    is_edited_ = true;
    is_accepted_ = false;
    say({});
}

void DistortionTablePresenter::removeRow(int row) {
    if (row > 0 && row < static_cast<int>(rows_.size())) {
        rows_.erase(rows_.begin() + row);
        is_edited_ = true;
        is_accepted_ = false;
        spread_rad_.clear();
        say({});
    }
}

void DistortionTablePresenter::forgetEdits() {
    is_edited_ = false;
    compute();
}

void DistortionTablePresenter::accept() {
    if (!canAccept()) {
        return;
    }
    camera::Rig rig = live_.model().rig();
    rig.lens = camera::Lens(camera::RadialTableLens{.cx_px = table_centre_.x(), .cy_px = table_centre_.y(), .rows = rows_});
    CalibrationRecord record;
    record.method = CalibrationMethod::kDistortionTable;
    double squares = 0;
    for (const double spread : spread_rad_) {
        squares += spread * spread / 4;
    }
    record.rms_px = spread_rad_.empty() ? 0.0 : rig.lens.focalLengthPx() * std::sqrt(squares / static_cast<double>(spread_rad_.size()));
    record.remark = is_edited_ ? tr("table edited by hand") : runTexts().join(QStringLiteral("; "));
    keepMeasuredRig(live_, preferences_, messages_, rig, record);
    is_accepted_ = true;
    say({});
}

void DistortionTablePresenter::say(const QString& trouble) {
    trouble_ = trouble;
    Q_EMIT changed();
}

}  // namespace pmts::app
