// What the recording presenter shows: the big digits and the sentence under them.
#include "pmts/app/field/recording_presenter.hpp"

#include "pmts/geometry/polar.hpp"

namespace pmts::app {

namespace {

constexpr core::Angle kSameTarget = core::Angle::fromMgon(50);  ///< past it a shot is shown as old

}  // namespace

void RecordingPresenter::onPointing(const TimedPointing& reading) {
    pointing_ = reading.pointing;
    refreshTexts();
}

void RecordingPresenter::setShot(ShotState state, const QString& sentence) {
    readings_.shot = state;
    readings_.sentence = sentence;
    refreshTexts();
}

void RecordingPresenter::say(const QString& sentence) {
    readings_.sentence = sentence;
    messages_.toast(sentence);
    Q_EMIT readingsChanged();
}

void RecordingPresenter::refreshTexts() {
    const UnitFormat& units = preferences_.units();
    Readings next;
    next.shot = readings_.shot;
    next.sentence = readings_.sentence;
    next.angle_unit = units.angleUnitSign();
    next.length_unit = units.lengthUnitSign();
    next.mode = modeNames().value(static_cast<int>(mode()));
    if (pointing_) {
        next.ha = units.directionNumber(pointing_->ha);
        next.va = units.angleNumber(pointing_->va);
    }
    if (observation_ && observation_->slope_distance_m) {
        next.sd = units.lengthNumber(*observation_->slope_distance_m);
        next.time_taken = tr("%1 s").arg(observation_->time_taken_s, 0, 'f', 1);
        next.mode = observation_->edm_mode;
    }
    if (coordinates_) {
        next.easting = units.lengthNumber(coordinates_->e_m);
        next.northing = units.lengthNumber(coordinates_->n_m);
        next.height = units.lengthNumber(coordinates_->h_m);
        next.precision = units.precision(coordinates_->sigma3dM());
    }
    next.shot_is_elsewhere =
        observation_ && pointing_ && geometry::separation(observation_->pointing, *pointing_) > kSameTarget;
    readings_ = next;
    Q_EMIT readingsChanged();
}

}  // namespace pmts::app
