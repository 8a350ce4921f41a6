#include "pmts/geometry/polar.hpp"
#include "pmts/survey/point.hpp"

#include <QCoreApplication>

#include <cmath>

namespace pmts::survey {
namespace {

/// Square roots of the diagonal of J diag(sd, va, ha) J^T, J the derivatives of E, N, H by SD, VA and HA.
Eigen::Vector3d sigmas(const Eigen::Vector3d& offset_m, core::Angle bearing, core::Angle va, double sd_m,
                       const InstrumentAccuracy& accuracy) {
    const double sigma_sd_m = std::hypot(accuracy.distance_m, accuracy.distance_ppm * 1e-6 * sd_m);
    const double sigma_angle = accuracy.angle.rad();
    const Eigen::Vector3d by_sd = offset_m / sd_m;
    const Eigen::Vector3d by_va = {sd_m * core::cos(va) * core::sin(bearing),
                                   sd_m * core::cos(va) * core::cos(bearing), -sd_m * core::sin(va)};
    const Eigen::Vector3d by_ha = {offset_m.y(), -offset_m.x(), 0.0};
    return ((by_sd * sigma_sd_m).cwiseAbs2() + (by_va * sigma_angle).cwiseAbs2() +
            (by_ha * sigma_angle).cwiseAbs2())
        .cwiseSqrt();
}

tl::unexpected<core::Error> withoutDistance(const Observation& observation) {
    const auto text = [](const char* sentence) {
        return QCoreApplication::translate("pmts::survey", sentence);
    };
    const QString reason =
        observation.absurd_reason.isEmpty() ? text("no distance was measured") : observation.absurd_reason;
    return core::fail(core::ErrorKind::kAbsurdPoint, text("The point has no coordinates: %1.").arg(reason),
                      text("Measure the distance again, or aim at a surface that sends light back."));
}

}  // namespace

double Coordinates::sigma3dM() const { return std::hypot(sigma_e_m, sigma_n_m, sigma_h_m); }

core::Result<Coordinates> coordinatesOf(const Station& station, const Observation& observation,
                                        const InstrumentAccuracy& accuracy) {
    if (!observation.slope_distance_m || !(*observation.slope_distance_m > 0.0)) {
        return withoutDistance(observation);
    }
    const double sd_m = *observation.slope_distance_m;
    const core::Angle bearing = observation.pointing.ha + station.orientation;
    const Eigen::Vector3d offset_m = geometry::stationFromPolar(
        {.pointing = {.ha = bearing, .va = observation.pointing.va}, .slope_distance_m = sd_m});
    const Eigen::Vector3d sigma_m = sigmas(offset_m, bearing, observation.pointing.va, sd_m, accuracy);
    return Coordinates{
        .e_m = station.e_m + offset_m.x(),
        .n_m = station.n_m + offset_m.y(),
        .h_m = station.h_m + station.instrument_height_m - observation.target_height_m + offset_m.z(),
        .sigma_e_m = sigma_m.x(),
        .sigma_n_m = sigma_m.y(),
        .sigma_h_m = sigma_m.z(),
    };
}

Eigen::Vector3d stationFrameFromGround(const Station& station, double e_m, double n_m, double h_m,
                                       double target_height_m) {
    const double east_m = e_m - station.e_m;
    const double north_m = n_m - station.n_m;
    // The ground's axes are the station frame's, turned back by the orientation about the vertical.
    const double s = core::sin(station.orientation);
    const double c = core::cos(station.orientation);
    return {c * east_m - s * north_m, s * east_m + c * north_m,
            h_m + target_height_m - station.h_m - station.instrument_height_m};
}

}  // namespace pmts::survey
