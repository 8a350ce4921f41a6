#include "pmts/survey/station.hpp"

#include <cmath>

namespace pmts::survey {

core::Angle orientationFor(core::Angle ha, core::Angle bearing) { return core::normalized(bearing - ha); }

core::Angle bearingTo(const Station& station, double e_m, double n_m) {
    return core::normalized(core::Angle::fromRad(std::atan2(e_m - station.e_m, n_m - station.n_m)));
}

}  // namespace pmts::survey
