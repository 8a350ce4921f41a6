#include "pmts/app/settings/aiming_settings.hpp"

#include "setting_values.hpp"

namespace pmts::app {

using core::Angle;

namespace {

constexpr double kNone_gon = -1.0;  ///< kept where there is no such limit

Angle angleFrom(const QSettings& file, const char* key, Angle fallback, double least_gon, double most_gon) {
    return Angle::fromGon(numberFrom(file, key, fallback.gon(), least_gon, most_gon));
}

std::optional<Angle> optionalFrom(const QSettings& file, const char* key, double most_gon) {
    const double value = numberFrom(file, key, kNone_gon, 0, most_gon);
    return value < 0 ? std::nullopt : std::optional(Angle::fromGon(value));
}

double gonOrNone(const std::optional<Angle>& angle) { return angle ? angle->gon() : kNone_gon; }

}  // namespace

targeting::RecentringSettings AimingSettings::recentring(Angle turn_tolerance) const {
    targeting::RecentringSettings settings;
    settings.turn_tolerance = turn_tolerance;
    settings.tolerance_px = tolerance_px;
    settings.tolerance = tolerance;
    return settings;
}

targeting::PointingGuardSettings AimingSettings::guard(Angle orientation) const {
    targeting::PointingGuardSettings settings;
    settings.limits = limits;
    settings.most_wound = most_wound;
    if (avoids_sun && place) {
        settings.sun = targeting::SunGuard{.place = *place, .azimuth_of_zero = orientation, .cone = sun_cone};
    }
    return settings;
}

void AimingSettings::load(const QSettings& file) {
    method = enumFrom(file, "aiming/method", method, static_cast<int>(targeting::Method::kRigorous));
    recentre = file.value(QStringLiteral("aiming/recentre"), recentre).toBool();
    click_turns = file.value(QStringLiteral("aiming/click_turns"), click_turns).toBool();
    tolerance_px = numberFrom(file, "aiming/tolerance_px", tolerance_px, 0.02, 10.0);
    tolerance = angleFrom(file, "aiming/tolerance_gon", tolerance, 0.0, 1.0);
    limits.highest = angleFrom(file, "aiming/highest_gon", limits.highest, 0, 200);
    limits.lowest = angleFrom(file, "aiming/lowest_gon", limits.lowest, 0, 200);
    limits.face_two_allowed = file.value(QStringLiteral("aiming/face_two"), limits.face_two_allowed).toBool();
    const auto from = optionalFrom(file, "aiming/sector_from_gon", 400);
    const auto to = optionalFrom(file, "aiming/sector_to_gon", 400);
    limits.ha_sector = from && to ? std::optional(std::pair(*from, *to)) : std::nullopt;
    avoids_sun = file.value(QStringLiteral("aiming/avoids_sun"), avoids_sun).toBool();
    if (file.contains(QStringLiteral("aiming/latitude_gon")) && file.contains(QStringLiteral("aiming/longitude_gon"))) {
        place = targeting::Place{.latitude = angleFrom(file, "aiming/latitude_gon", {}, -100, 100),
                                 .longitude = angleFrom(file, "aiming/longitude_gon", {}, -200, 200)};
    }
    sun_cone = angleFrom(file, "aiming/sun_cone_gon", sun_cone, 1, 100);
    most_wound = optionalFrom(file, "aiming/most_wound_gon", 4000);
}

void AimingSettings::save(QSettings& file) const {
    file.beginGroup(QStringLiteral("aiming"));
    file.remove(QString());  // a place that was taken away must not come back
    file.setValue(QStringLiteral("method"), static_cast<int>(method));
    file.setValue(QStringLiteral("recentre"), recentre);
    file.setValue(QStringLiteral("click_turns"), click_turns);
    file.setValue(QStringLiteral("tolerance_px"), tolerance_px);
    file.setValue(QStringLiteral("tolerance_gon"), tolerance.gon());
    file.setValue(QStringLiteral("highest_gon"), limits.highest.gon());
    file.setValue(QStringLiteral("lowest_gon"), limits.lowest.gon());
    file.setValue(QStringLiteral("face_two"), limits.face_two_allowed);
    file.setValue(QStringLiteral("sector_from_gon"), limits.ha_sector ? limits.ha_sector->first.gon() : kNone_gon);
    file.setValue(QStringLiteral("sector_to_gon"), limits.ha_sector ? limits.ha_sector->second.gon() : kNone_gon);
    file.setValue(QStringLiteral("avoids_sun"), avoids_sun);
    if (place) {
        file.setValue(QStringLiteral("latitude_gon"), place->latitude.gon());
        file.setValue(QStringLiteral("longitude_gon"), place->longitude.gon());
    }
    file.setValue(QStringLiteral("sun_cone_gon"), sun_cone.gon());
    file.setValue(QStringLiteral("most_wound_gon"), gonOrNone(most_wound));
    file.endGroup();
}

}  // namespace pmts::app
