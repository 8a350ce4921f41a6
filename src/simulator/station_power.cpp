#include "pmts/geometry/polar.hpp"
#include "station_impl.hpp"

namespace pmts::simulator {

void Station::Impl::switchOff() {
    if (power_ == Power::kOff) {
        return;
    }
    power_ = Power::kOff;
    switched_off_at_ = clock_.now();
    servo_.stop();
    busy_ = waits_for_distance_ = false;
    meter_.stop();
    meter_.forget();
    heard_.clear();
    said_.clear();
    queue_.clear();
    line_.clear();
    load_.reset();
    for (core::Timer* timer : {&line_timer_, &idle_timer_, &late_timer_, &calibration_timer_, &load_timer_}) {
        timer->cancel();
    }
    for (const int coordinate : {protocol::kNorthing, protocol::kEasting, protocol::kElevation}) {
        labels_.setNumber(coordinate, 0.0);
    }
}

void Station::Impl::switchOn(bool keep_values) {
    power_ = Power::kReady;
    if (!keep_values) {
        labels_.reset();
        cu_labels_.reset();
        orientation_ = {};
        face_two_.reset();
        end_mark_ = settings_.end_mark;
        setPace(settings_.baud);
    }
    watchIdle();
}

void Station::Impl::receiveBreak() {
    if (power_ != Power::kOff) {
        return;
    }
    const bool kept = clock_.now() - switched_off_at_ < settings_.values_kept;
    if (!kept || !settings_.ask_to_continue) {
        switchOn(kept);
        return;
    }
    power_ = Power::kAsking;
    said_.put("!");
    watchIdle();
}

void Station::Impl::answerContinue(const std::string& line) {
    current_ = line;
    if (line != "Y" && line != "N") {
        emitBlock({statusText(info::kSyntax), {}});
        return;
    }
    switchOn(line == "Y");
    emitBlock({});
}

void Station::Impl::startCalibration() {
    if (!settings_.calibration_asks) {
        calibrate();
        return;
    }
    power_ = Power::kAskingToCalibrate;
    said_.put("!");
}

void Station::Impl::answerCalibration(const std::string& line) {
    if (line == "Y") {
        calibrate();
    } else if (line == "N") {
        power_ = Power::kReady;
        answerDone();
    } else {
        emitBlock({statusText(info::kSyntax), {}});
    }
}

/// Face I, half a turn, face II, and back; `@` says that the compensator is being displayed.
void Station::Impl::calibrate() {
    power_ = Power::kCalibrating;
    said_.put("@");
    const geometry::Pointing home = pointing_->at(clock_.now());
    calibration_timer_ = clock_.callAfter(settings_.calibration_per_face, [this, home] {
        servo_.turnTo(geometry::otherFace(home), [this, home] { calibrateSecondFace(home); });
    });
}

void Station::Impl::calibrateSecondFace(const geometry::Pointing& home) {
    calibration_timer_ = clock_.callAfter(settings_.calibration_per_face, [this, home] {
        servo_.turnTo(home, [this] {
            power_ = Power::kReady;
            answerDone();
        });
    });
}

}  // namespace pmts::simulator
