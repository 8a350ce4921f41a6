#include "record_check.hpp"

#include <cmath>

namespace pmts::soak {
namespace {

using core::Angle;

constexpr double kDistanceBand_m = 5 * 0.0032;  ///< five sigma: 3 mm and 3 ppm
constexpr double kCircleBand_cc = 16;           ///< five sigma of 3 cc
constexpr double kCoordinateBand_m = 1e-6;      ///< the same formula twice
constexpr double kSameNumber = 1e-9;

/// The number behind `label=` of a line of the block.
std::optional<double> numberIn(const QString& block, int label) {
    const QString start = QString::number(label) + u'=';
    for (const QString& line : block.split(u'\n')) {
        if (line.startsWith(start)) {
            bool is_number = false;
            const double number = line.mid(start.size()).trimmed().toDouble(&is_number);
            return is_number ? std::optional(number) : std::nullopt;
        }
    }
    return std::nullopt;
}

double offEnh_m(const survey::Point& point, double sd_m, const survey::Station& station) {
    const double ha = point.observation.pointing.ha.rad(), va = point.observation.pointing.va.rad();
    const double bearing = ha + station.orientation.rad();
    return std::hypot(point.coordinates.e_m - (station.e_m + sd_m * std::sin(va) * std::sin(bearing)),
                      point.coordinates.n_m - (station.n_m + sd_m * std::sin(va) * std::cos(bearing)),
                      point.coordinates.h_m - (station.h_m + station.instrument_height_m -
                                               point.observation.target_height_m + sd_m * std::cos(va)));
}

}  // namespace

QString wrongIn(const survey::Point& point, const Truth& truth, const survey::Station& station) {
    const Angle off_ha = core::normalizedSigned(point.observation.pointing.ha - truth.pointing.ha);
    const Angle off_va = core::normalizedSigned(point.observation.pointing.va - truth.pointing.va);
    const auto sd_m = point.observation.slope_distance_m;
    const bool circles_right = std::abs(off_ha.cc()) <= kCircleBand_cc && std::abs(off_va.cc()) <= kCircleBand_cc;
    const bool distance_right = sd_m ? truth.distance_m && std::abs(*sd_m - *truth.distance_m) <= kDistanceBand_m &&
                                           offEnh_m(point, *sd_m, station) <= kCoordinateBand_m
                                     : !point.observation.absurd_reason.isEmpty();
    if (circles_right && distance_right) {
        return {};
    }
    return QStringLiteral("SD %1 m instead of %2 m, HA off %3 cc, VA off %4 cc, ENH off %5 m: %6")
        .arg(sd_m.value_or(0.0)).arg(truth.distance_m.value_or(0.0)).arg(off_ha.cc()).arg(off_va.cc())
        .arg(sd_m ? offEnh_m(point, *sd_m, station) : 0.0).arg(point.observation.raw_reply);
}

QString wrongOfBlock(const survey::Point& point) {
    const QString& block = point.observation.raw_reply;
    const auto ha_gon = numberIn(block, 7), va_gon = numberIn(block, 8), sd_m = numberIn(block, 9);
    const bool circles_right = ha_gon && va_gon && std::abs(point.observation.pointing.ha.gon() - *ha_gon) < kSameNumber &&
                               std::abs(point.observation.pointing.va.gon() - *va_gon) < kSameNumber;
    const auto kept_m = point.observation.slope_distance_m;
    const bool distance_right = sd_m ? kept_m && std::abs(*kept_m - *sd_m) < kSameNumber
                                     : !kept_m && !point.observation.absurd_reason.isEmpty();
    return circles_right && distance_right ? QString() : QStringLiteral("not as its block: ") + block;
}

}  // namespace pmts::soak
