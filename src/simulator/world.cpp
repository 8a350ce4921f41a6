#include "pmts/simulator/world.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::simulator {
namespace {

double seconds(core::Duration span) { return std::chrono::duration<double>(span).count(); }

core::Duration fromSeconds(double s) {
    return std::chrono::ceil<core::Duration>(std::chrono::duration<double>(s));
}

/// The three legs of a motion along its own direction, in gon and seconds.
struct Legs {
    double speed_up_s = 0.0, cruise_s = 0.0, brake_s = 0.0;
    double start_speed = 0.0, top_speed = 0.0, acceleration = 1.0;

    [[nodiscard]] double total() const { return speed_up_s + cruise_s + brake_s; }

    [[nodiscard]] double way(double t) const {
        const double up = std::clamp(t, 0.0, speed_up_s);
        const double cruise = std::clamp(t - speed_up_s, 0.0, cruise_s);
        const double brake = std::clamp(t - speed_up_s - cruise_s, 0.0, brake_s);
        return start_speed * up + 0.5 * acceleration * up * up + top_speed * cruise + top_speed * brake -
               0.5 * acceleration * brake * brake;
    }

    [[nodiscard]] double speed(double t) const {
        if (t < 0.0 || t >= total()) {
            return 0.0;
        }
        if (t < speed_up_s) {
            return start_speed + acceleration * t;
        }
        return top_speed - acceleration * std::max(t - speed_up_s - cruise_s, 0.0);
    }
};

Legs legsOf(const AxisMotion& motion) {
    const double way = std::abs(motion.end_gon - motion.start_gon);
    const double a = motion.acceleration_gon_s2;
    const double v0 = std::min(motion.start_speed_gon_s, std::sqrt(2.0 * a * way));
    const double top = std::max(std::min(motion.speed_gon_s, std::sqrt(a * way + 0.5 * v0 * v0)), v0);
    const double ramps = (top * top - v0 * v0) / (2.0 * a) + top * top / (2.0 * a);
    return {.speed_up_s = (top - v0) / a,
            .cruise_s = top > 0.0 ? std::max(way - ramps, 0.0) / top : 0.0,
            .brake_s = top / a,
            .start_speed = v0,
            .top_speed = top,
            .acceleration = a};
}

double sign(const AxisMotion& motion) { return motion.end_gon < motion.start_gon ? -1.0 : 1.0; }

}  // namespace

double AxisMotion::positionGon(core::Duration at) const {
    if (at <= started_at) {
        return start_gon;
    }
    const Legs legs = legsOf(*this);
    const double t = seconds(at - started_at);
    return t >= legs.total() ? end_gon : start_gon + sign(*this) * legs.way(t);
}

double AxisMotion::speedGonS(core::Duration at) const {
    return sign(*this) * legsOf(*this).speed(seconds(at - started_at));
}

core::Duration AxisMotion::duration() const { return fromSeconds(legsOf(*this).total()); }

AxisMotion AxisMotion::brakedAt(core::Duration at) const {
    const double here = positionGon(at);
    const double speed = speedGonS(at);
    AxisMotion braking = *this;
    braking.start_gon = here;
    braking.end_gon = here + std::copysign(speed * speed / (2.0 * acceleration_gon_s2), speed);
    braking.started_at = at;
    braking.start_speed_gon_s = std::abs(speed);
    return braking;
}

geometry::Pointing TruePointing::at(core::Duration time) const {
    const std::lock_guard lock(mutex_);
    return {.ha = core::normalized(core::Angle::fromGon(motions_.ha.positionGon(time))),
            .va = core::normalized(core::Angle::fromGon(motions_.va.positionGon(time)))};
}

AxisMotions TruePointing::motions() const {
    const std::lock_guard lock(mutex_);
    return motions_;
}

void TruePointing::setMotion(const AxisMotion& ha, const AxisMotion& va) {
    const std::lock_guard lock(mutex_);
    motions_ = {.ha = ha, .va = va};
}

void TruePointing::place(const geometry::Pointing& pointing) {
    const double va_gon = core::normalizedSigned(pointing.va).gon();
    setMotion({.start_gon = pointing.ha.gon(), .end_gon = pointing.ha.gon()},
              {.start_gon = va_gon, .end_gon = va_gon});
}

}  // namespace pmts::simulator
