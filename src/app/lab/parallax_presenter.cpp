#include "pmts/app/lab/parallax_presenter.hpp"

#include "field/spot_at.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::app {

namespace {

using calibration::Sighting;

constexpr core::Angle kOnTheMark = core::Angle::fromMgon(50);
constexpr core::Angle kSameView = core::Angle::fromGon(1);
constexpr double kWanted_m = 0.01;  ///< an offset this small shall still be found

QString millimetres(double length_m) { return QStringLiteral("%1 mm").arg(1000 * length_m, 0, 'f', 1); }

QString acrossText(const Eigen::Vector2d& right_up_m) {
    const QString across = right_up_m.x() < 0 ? ParallaxPresenter::tr("%1 to the left") : ParallaxPresenter::tr("%1 to the right");
    const QString up = right_up_m.y() < 0 ? ParallaxPresenter::tr("%1 down") : ParallaxPresenter::tr("%1 up");
    return QStringLiteral("%1, %2").arg(across.arg(millimetres(std::abs(right_up_m.x()))), up.arg(millimetres(std::abs(right_up_m.y()))));
}

}  // namespace

ParallaxPresenter::ParallaxPresenter(LivePresenter& live, InstrumentDesk& instrument, RangeKeeper& range, Preferences& preferences,
                                     MessageCentre& messages, Threading threading, QObject* parent)
    : QObject(parent), live_(live), instrument_(instrument), range_(range), preferences_(preferences), messages_(messages),
      threading_(threading) {
    connect(&instrument_, &InstrumentDesk::distanceMeasured, this, [this](Ticket ticket, const instrument::DistanceShot& shot) {
        if (ticket == ticket_) {
            ticket_ = 0;
            range_.addShot(shot.pointing, shot.slope_distance_m);
            board() = {.target = geometry::PolarPoint{shot.pointing, shot.slope_distance_m}, .sightings = {}};
            clicked_px_.reset();  // the telescope has left what was clicked before
            say({});
        }
    });
    connect(&instrument_, &InstrumentDesk::requestFailed, this, [this](Ticket ticket, const core::Error& error) {
        if (ticket == ticket_) {
            ticket_ = 0;
            say(error.sentence());
        }
    });
}

ParallaxPresenter::Board& ParallaxPresenter::board() {
    return stage_ == ParallaxStage::kFar ? far_ : stage_ == ParallaxStage::kVerify ? proof_ : near_;
}

const ParallaxPresenter::Board& ParallaxPresenter::board() const {
    return stage_ == ParallaxStage::kFar ? far_ : stage_ == ParallaxStage::kVerify ? proof_ : near_;
}

bool ParallaxPresenter::isSighted(const Board& board) const { return !board.sightings.empty(); }

std::vector<Sighting> ParallaxPresenter::allSightings() const {
    std::vector<Sighting> all = far_.sightings;
    all.insert(all.end(), near_.sightings.begin(), near_.sightings.end());
    return all;
}

DeviceState ParallaxPresenter::state() const {
    if (isMeasuring()) {
        return DeviceState::kBusy;
    }
    if (!trouble_.isEmpty()) {
        return DeviceState::kFailed;
    }
    if (proof_px_) {
        return *proof_px_ <= kGood_px ? DeviceState::kGood : DeviceState::kWarning;
    }
    return fit_ ? DeviceState::kWarning : DeviceState::kIdle;
}

QString ParallaxPresenter::step() const {
    if (isMeasuring()) {
        return tr("Measuring the distance.");
    }
    if (!trouble_.isEmpty()) {
        return trouble_;
    }
    const bool sighted = board().target.has_value();
    switch (stage_) {
        case ParallaxStage::kFar:
            return sighted ? tr("Click the far mark in the picture.")
                           : tr("Point the telescope at the mark of the far board and measure its distance.");
        case ParallaxStage::kNear:
            return sighted ? tr("Click the near mark in the picture.")
                           : tr("Point the telescope at the mark of the near board and measure its distance.");
        case ParallaxStage::kAside:
            return tr("Turn until the near mark is near the left edge and click it; then the same at the right edge.");
        case ParallaxStage::kAccept: return tr("Press Accept: the offsets go into the rig.");
        case ParallaxStage::kVerify: break;
    }
    if (proof_px_) {
        return *proof_px_ <= kGood_px ? tr("The offsets hold. Go on with the distortion table.")
                                      : tr("They do not hold: sight both boards again.");
    }
    return sighted ? tr("Click this mark in the picture.")
                   : tr("Verify: point the telescope at a mark at any distance and measure it.");
}

std::vector<ParallaxStep> ParallaxPresenter::steps() const {
    const bool aside_is_done = !sought_.y || near_.sightings.size() >= 3;
    std::vector<ParallaxStep> all{
        {tr("a  Choose the offsets sought"), true},
        {tr("b  Hang a board at D and one at 2D"), far_.target.has_value()},
        {tr("c  Telescope on the far mark"), far_.target.has_value()},
        {tr("d  Distance of the far mark"), far_.target.has_value()},
        {tr("e  Click it: there the axes meet"), isSighted(far_)},
        {tr("f  Telescope on the near mark"), near_.target.has_value()},
        {tr("g  Distance of the near mark"), near_.target.has_value()},
        {tr("h  Click it: half the offset is seen"), isSighted(near_)},
        {sought_.y ? tr("i  Near mark left and right in the picture") : tr("i  Marks aside: for Yo only"), aside_is_done && isSighted(near_)},
        {tr("j  Take the offsets into the rig"), is_accepted_},
        {tr("k  Verify on any mark"), proof_px_.has_value() && *proof_px_ <= kGood_px},
    };
    const auto next = std::find_if(all.begin(), all.end(), [](const ParallaxStep& line) { return !line.done; });
    if (next != all.end()) {
        next->current = true;
    }
    return all;
}

QString ParallaxPresenter::boardsAdvice() const {
    const double f_px = live_.model().rig().lens.focalLengthPx();
    const auto range = calibration::nearBoardRange({.offset_m = kWanted_m}, f_px);
    const UnitFormat& units = preferences_.units();
    if (!near_.target) {
        return tr("D from %1 (telescope and camera focus) to %2 (there a pixel is as wide as an offset of %3).")
            .arg(units.length(range.least_m), units.length(range.most_m), millimetres(kWanted_m));
    }
    const double near_m = near_.target->slope_distance_m;
    if (!range.holds(near_m)) {
        return near_m <= range.least_m ? tr("The near board is too near: at least %1.").arg(units.length(range.least_m))
                                       : tr("The near board is too far: a pixel is %1 wide there.").arg(millimetres(near_m / f_px));
    }
    return tr("D = %1: a pixel is %2 wide there.").arg(units.length(near_m), millimetres(near_m / f_px));
}

QString ParallaxPresenter::distanceText() const {
    return board().target ? preferences_.units().length(board().target->slope_distance_m) : QStringLiteral("–");
}

QString ParallaxPresenter::gapText() const {
    if (!gap_) {
        return QStringLiteral("–");
    }
    return tr("%1 at %2; times %3 is the offset")
        .arg(acrossText(gap_->gap_m), preferences_.units().length(gap_->near_m))
        .arg(gap_->far_m / (gap_->far_m - gap_->near_m), 0, 'f', 2);
}

QString ParallaxPresenter::offsetsText() const {
    if (!fit_) {
        return QStringLiteral("–");
    }
    QStringList lines;
    static constexpr std::array kNames{"Xo", "Yo", "Zo"};
    for (std::size_t axis = 0; axis < kNames.size(); ++axis) {
        const double value = fit_->mount.offset_m(static_cast<Eigen::Index>(axis));
        const auto& sigma = fit_->offset_sigma_m[axis];
        lines.append(sigma ? tr("%1  %2 ± %3").arg(QLatin1String(kNames[axis]), millimetres(value), millimetres(*sigma))
                           : tr("%1  %2 (not sought)").arg(QLatin1String(kNames[axis]), millimetres(value)));
    }
    return lines.join(u'\n');
}

QString ParallaxPresenter::proofText() const { return proof_text_; }

void ParallaxPresenter::setSought(const calibration::OffsetCase& sought) {
    sought_ = sought;
    is_accepted_ = false;
    solve();
    goOn();
}

void ParallaxPresenter::setStage(ParallaxStage stage) {
    stage_ = stage;
    clicked_px_.reset();
    say({});
}

void ParallaxPresenter::measure() {
    if (isMeasuring()) {
        return;
    }
    if (stage_ == ParallaxStage::kAccept) {
        setStage(ParallaxStage::kNear);
    }
    ticket_ = instrument_.measureDistance();
    say({});
}

void ParallaxPresenter::setDistance(double distance_m) {
    const auto newest = instrument_.track().newest();
    if (!newest || !(distance_m > 0)) {
        return say(tr("There is no circle reading: connect the instrument."));
    }
    board() = {.target = geometry::PolarPoint{newest->pointing, distance_m}, .sightings = {}};
    say({});
}

void ParallaxPresenter::click(const QPointF& frame_px) {
    const LiveScene& scene = live_.scene();
    if (!board().target) {
        return say(tr("Measure the distance to this mark first."));
    }
    if (!scene.frame || !scene.pointing || scene.moving) {
        return say(tr("Wait until the telescope stands still, then click."));
    }
    inPool(
        threading_, this, [frame = scene.frame, px = Eigen::Vector2d(frame_px.x(), frame_px.y())] { return spotAt(frame, px); },
        [this, at = *scene.pointing, target = board().target, stage = stage_](const Eigen::Vector2d& px) {
            if (stage == stage_ && target) {
                take({.px = px, .at = at, .target = *target});
            }
        });
}

void ParallaxPresenter::take(const Sighting& sighting) {
    clicked_px_ = QPointF(sighting.px.x(), sighting.px.y());
    const bool is_on_mark = geometry::separation(sighting.at, sighting.target.pointing) < kOnTheMark;
    if (!is_on_mark && stage_ != ParallaxStage::kAside) {
        return say(tr("The telescope has left the mark: point at it again and measure."));
    }
    std::vector<Sighting>& known = board().sightings;
    std::erase_if(known, [&](const Sighting& old) { return geometry::separation(old.at, sighting.at) < kSameView; });
    known.insert(is_on_mark ? known.begin() : known.end(), sighting);  // the gap is taken from the first
    trouble_.clear();
    if (stage_ == ParallaxStage::kVerify) {
        return judge(sighting);
    }
    solve();
    goOn();
}

/// To the first stage that still wants something; past a trouble only by hand.
void ParallaxPresenter::goOn() {
    if (!isSighted(far_)) {
        stage_ = ParallaxStage::kFar;
    } else if (!isSighted(near_)) {
        stage_ = ParallaxStage::kNear;
    } else if (wantsAside()) {
        stage_ = ParallaxStage::kAside;
    } else {
        stage_ = is_accepted_ ? ParallaxStage::kVerify : ParallaxStage::kAccept;
    }
    Q_EMIT changed();
}

void ParallaxPresenter::solve() {
    gap_.reset();
    fit_.reset();
    proof_px_.reset();
    proof_text_.clear();
    is_accepted_ = false;
    trouble_.clear();
    if (!isSighted(far_) || !isSighted(near_)) {
        return;
    }
    const camera::Rig& rig = live_.model().rig();
    const auto gap = calibration::gapAtNearBoard(rig, far_.sightings.front(), near_.sightings.front());
    if (!gap) {
        trouble_ = gap.error().sentence();
        return;
    }
    gap_ = *gap;
    if (wantsAside()) {
        return;
    }
    const auto fit = calibration::fitMount(allSightings(), rig, sought_);
    if (!fit) {
        trouble_ = fit.error().sentence();
        return;
    }
    fit_ = *fit;
}

void ParallaxPresenter::accept() {
    if (!fit_) {
        return;
    }
    camera::Rig rig = live_.model().rig();
    rig.mount = fit_->mount;
    CalibrationRecord record;
    record.method = CalibrationMethod::kMounting;
    record.rms_px = fit_->rms_px;
    record.remark = tr("boards at %1 and %2").arg(preferences_.units().length(near_.target->slope_distance_m),
                                                  preferences_.units().length(far_.target->slope_distance_m));
    static constexpr std::array kNames{"Xo [m]", "Yo [m]", "Zo [m]"};
    for (std::size_t axis = 0; axis < kNames.size(); ++axis) {
        if (fit_->offset_sigma_m[axis]) {
            record.standard_deviations[QLatin1String(kNames[axis])] = *fit_->offset_sigma_m[axis];
        }
    }
    keepMeasuredRig(live_, preferences_, messages_, rig, record);
    is_accepted_ = true;
    proof_ = {};
    goOn();
}

void ParallaxPresenter::judge(const Sighting& proof) {
    const auto expected = live_.model().pixelForPoint(geometry::stationFromPolar(proof.target), proof.at);
    if (!expected) {
        return say(expected.error().sentence());
    }
    const Eigen::Vector2d off = proof.px - *expected;
    proof_px_ = off.norm();
    const double wide_m = proof.target.slope_distance_m / live_.model().rig().lens.focalLengthPx();
    proof_text_ = tr("At %1 the mark is %2 px (%3) from where the rig says.")
                      .arg(preferences_.units().length(proof.target.slope_distance_m))
                      .arg(off.norm(), 0, 'f', 2)
                      .arg(millimetres(off.norm() * wide_m));
    Q_EMIT changed();
}

void ParallaxPresenter::startAgain() {
    far_ = near_ = proof_ = {};
    clicked_px_.reset();
    solve();
    goOn();
}

void ParallaxPresenter::say(const QString& trouble) {
    trouble_ = trouble;
    Q_EMIT changed();
}

}  // namespace pmts::app
