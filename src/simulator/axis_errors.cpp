#include "axis_errors.hpp"

#include <cmath>

namespace pmts::simulator {
namespace {

using core::Angle;

/// Near the plumb line the formulas grow without bound; no telescope is read there.
double safeSine(Angle va) {
    constexpr double kLeastSine = 0.01;
    const double sine = core::sin(va);
    return std::abs(sine) < kLeastSine ? std::copysign(kLeastSine, sine) : sine;
}

/// Tilt along the line of sight (towards the target, positive) and across it (to the right).
struct Tilt {
    Angle along, across;
};

Tilt tiltSeenFrom(const StationSettings& errors, Angle ha, bool compensated) {
    if (compensated) {
        return {};
    }
    return {.along = errors.tilt_north * core::cos(ha) + errors.tilt_east * core::sin(ha),
            .across = errors.tilt_east * core::cos(ha) - errors.tilt_north * core::sin(ha)};
}

Angle haError(const StationSettings& errors, const geometry::Pointing& truth, Angle tilt_across) {
    const double sine = safeSine(truth.va);
    return errors.collimation / sine + (errors.trunnion_error + tilt_across) * (core::cos(truth.va) / sine);
}

}  // namespace

geometry::Pointing circleReading(const StationSettings& errors, const geometry::Pointing& true_pointing,
                                 bool compensated) {
    const Tilt tilt = tiltSeenFrom(errors, true_pointing.ha, compensated);
    return {.ha = core::normalized(true_pointing.ha + haError(errors, true_pointing, tilt.across)),
            .va = core::normalized(true_pointing.va + errors.index_error + tilt.along)};
}

geometry::Pointing trueFromReading(const StationSettings& errors, const geometry::Pointing& reading,
                                   bool compensated) {
    geometry::Pointing truth = reading;
    for (int pass = 0; pass < 3;
         ++pass) {  // the errors change the pointing by mgon: three passes leave 1e-6 cc
        const geometry::Pointing shown = circleReading(errors, truth, compensated);
        truth.ha += core::normalizedSigned(reading.ha - shown.ha);
        truth.va += core::normalizedSigned(reading.va - shown.va);
    }
    return {.ha = core::normalized(truth.ha), .va = core::normalized(truth.va)};
}

}  // namespace pmts::simulator
