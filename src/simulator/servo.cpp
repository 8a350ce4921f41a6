#include "servo.hpp"

#include <algorithm>

namespace pmts::simulator {

using core::Angle;

Servo::Servo(const StationSettings& settings, core::Clock& clock, std::shared_ptr<TruePointing> pointing)
    : settings_(settings), clock_(clock), pointing_(std::move(pointing)) {}

void Servo::turnTo(const geometry::Pointing& true_target, std::function<void()> done) {
    turn(true_target, 1.0, std::move(done));
}

void Servo::turnHalfWayTo(const geometry::Pointing& true_target, std::function<void()> done) {
    turn(true_target, 0.5, std::move(done));
}

void Servo::turn(const geometry::Pointing& true_target, double part, std::function<void()> done) {
    const auto now = clock_.now();
    const geometry::Pointing here = pointing_->at(now);
    const auto motionOf = [&](double from_gon, double way_gon) {
        return AxisMotion{.start_gon = from_gon,
                          .end_gon = from_gon + part * way_gon,
                          .started_at = now,
                          .speed_gon_s = settings_.speed_gon_s,
                          .acceleration_gon_s2 = settings_.acceleration_gon_s2};
    };
    const Angle va_here = core::normalizedSigned(here.va);
    const AxisMotion ha = motionOf(here.ha.gon(), core::normalizedSigned(true_target.ha - here.ha).gon());
    const AxisMotion va = motionOf(va_here.gon(), (core::normalizedSigned(true_target.va) - va_here).gon());
    pointing_->setMotion(ha, va);
    turning_ = true;
    const auto longest = std::max(ha.duration(), va.duration());
    const auto settled = longest > core::Duration{0} ? longest + settings_.settle : longest;
    timer_ = clock_.callAfter(settled, [this, done = std::move(done)] {
        turning_ = false;
        done();
    });
}

void Servo::stop() {
    const auto now = clock_.now();
    const AxisMotions motions = pointing_->motions();
    pointing_->setMotion(motions.ha.brakedAt(now), motions.va.brakedAt(now));
    timer_.cancel();
    turning_ = false;
}

}  // namespace pmts::simulator
