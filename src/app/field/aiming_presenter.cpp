#include "pmts/app/field/aiming_presenter.hpp"

#include "pmts/targeting/click_method.hpp"
#include "pmts/targeting/sun_position.hpp"

#include <cmath>

namespace pmts::app {

using core::Angle;

namespace {

constexpr int kMethods = static_cast<int>(targeting::Method::kRigorous) + 1;
constexpr double kGonPerTurn = 400.0;

/// A circle of latitude or longitude as people write it.
QString degrees(Angle angle) { return QStringLiteral("%1°").arg(angle.deg(), 0, 'f', 4); }

}  // namespace

/// Reads the fields one after another; the first that cannot be read ends it.
struct AimingPresenter::Reading {
    AimingPresenter& page;
    bool is_fine = true;

    void refuse(AimingField field, const core::Error& error) {
        if (is_fine) {
            is_fine = false;
            Q_EMIT page.fieldRejected(field, error);
        }
    }
    Angle angle(AimingField field, const QString& text, double least_gon, double most_gon) {
        const auto value = page.preferences_.units().parseAngle(text);
        if (!value) {
            refuse(field, value.error());
            return {};
        }
        if (value->gon() < least_gon || value->gon() > most_gon) {
            const UnitFormat& units = page.preferences_.units();
            refuse(field, outside(text, units.angle(Angle::fromGon(least_gon)), units.angle(Angle::fromGon(most_gon))));
        }
        return *value;
    }
    double number(AimingField field, const QString& text, double least, double most) {
        bool is_number = false;
        const double value = QString(text).replace(u',', u'.').toDouble(&is_number);
        if (!is_number || value < least || value > most) {
            refuse(field, outside(text, QString::number(least), QString::number(most)));
        }
        return value;
    }
    /// Latitude and longitude are degrees unless another unit is written.
    Angle degreesOr(AimingField field, const QString& text, double most_deg) {
        UnitFormat units = page.preferences_.units();
        units.angle_unit = core::AngleUnit::kDegree;
        const auto value = units.parseAngle(text);
        if (!value) {
            refuse(field, value.error());
            return {};
        }
        if (std::abs(value->deg()) > most_deg) {
            refuse(field, outside(text, QStringLiteral("-%1°").arg(most_deg), QStringLiteral("%1°").arg(most_deg)));
        }
        return *value;
    }
    static core::Error outside(const QString& text, const QString& least, const QString& most) {
        return {.kind = core::ErrorKind::kBadInput,
                .happened = tr("“%1” is not between %2 and %3.").arg(text, least, most),
                .remedy = tr("Type a value between them."),
                .info_code = std::nullopt,
                .detail = {}};
    }
};

AimingPresenter::AimingPresenter(Preferences& preferences, InstrumentDesk& instrument, const StationPresenter& station,
                                 const core::Clock& clock, QObject* parent)
    : QObject(parent), preferences_(preferences), instrument_(instrument), station_(station), clock_(clock) {
    connect(&preferences_, &Preferences::changed, this, &AimingPresenter::changed);
    connect(&preferences_, &Preferences::unitsChanged, this, &AimingPresenter::changed);
    connect(&instrument_, &InstrumentDesk::woundChanged, this, &AimingPresenter::changed);
    connect(&station_, &StationPresenter::stationChanged, this, &AimingPresenter::changed);
}

QStringList AimingPresenter::methodNames() {
    QStringList names;
    for (int i = 0; i < kMethods; ++i) {
        names.append(targeting::methodName(static_cast<targeting::Method>(i)));
    }
    return names;
}

QString AimingPresenter::methodError(int method) {
    return targeting::methodError(static_cast<targeting::Method>(method));
}

AimingForm AimingPresenter::form() const {
    const AimingSettings& aiming = preferences_.settings().aiming;
    const UnitFormat& units = preferences_.units();
    AimingForm form{.method = static_cast<int>(aiming.method),
                    .recentre = aiming.recentre,
                    .click_turns = aiming.click_turns,
                    .tolerance_px = QString::number(aiming.tolerance_px),
                    .tolerance = units.smallAngle(aiming.tolerance),
                    .highest = units.angle(aiming.limits.highest),
                    .lowest = units.angle(aiming.limits.lowest),
                    .face_two_allowed = aiming.limits.face_two_allowed,
                    .has_sector = aiming.limits.ha_sector.has_value(),
                    .sector_from = {},
                    .sector_to = {},
                    .avoids_sun = aiming.avoids_sun,
                    .latitude = aiming.place ? degrees(aiming.place->latitude) : QString(),
                    .longitude = aiming.place ? degrees(aiming.place->longitude) : QString(),
                    .sun_cone = units.angle(aiming.sun_cone),
                    .watches_cable = aiming.most_wound.has_value(),
                    .turns = QString::number(aiming.most_wound.value_or(Angle::fromGon(600)).gon() / kGonPerTurn)};
    const auto sector = aiming.limits.ha_sector.value_or(std::pair(Angle::fromGon(300), Angle::fromGon(100)));
    form.sector_from = units.direction(sector.first);
    form.sector_to = units.direction(sector.second);
    return form;
}

void AimingPresenter::apply(const AimingForm& form) {
    Reading read{*this};
    AimingSettings next;
    next.method = static_cast<targeting::Method>(form.method);
    next.recentre = form.recentre;
    next.click_turns = form.click_turns;
    next.tolerance_px = read.number(AimingField::kTolerancePx, form.tolerance_px, 0.02, 10.0);
    next.tolerance = read.angle(AimingField::kTolerance, form.tolerance, 0.0, 1.0);
    next.limits.highest = read.angle(AimingField::kHighest, form.highest, 0, 200);
    next.limits.lowest = read.angle(AimingField::kLowest, form.lowest, next.limits.highest.gon(), 200);
    next.limits.face_two_allowed = form.face_two_allowed;
    if (form.has_sector) {
        const Angle from = read.angle(AimingField::kSectorFrom, form.sector_from, 0, 400);
        next.limits.ha_sector = std::pair(from, read.angle(AimingField::kSectorTo, form.sector_to, 0, 400));
    }
    next.avoids_sun = form.avoids_sun;
    if (form.avoids_sun || !form.latitude.isEmpty() || !form.longitude.isEmpty()) {
        const Angle latitude = read.degreesOr(AimingField::kLatitude, form.latitude, 90);
        next.place = targeting::Place{latitude, read.degreesOr(AimingField::kLongitude, form.longitude, 180)};
    }
    next.sun_cone = read.angle(AimingField::kSunCone, form.sun_cone, 1, 100);
    if (form.watches_cable) {
        next.most_wound = Angle::fromGon(read.number(AimingField::kTurns, form.turns, 0.25, 10) * kGonPerTurn);
    }
    if (read.is_fine) {
        Settings settings = preferences_.settings();
        settings.aiming = next;
        preferences_.set(settings);
        Q_EMIT applied(tr("Aiming: %1.").arg(summary()));
    }
}

QString AimingPresenter::summary() const {
    const AimingSettings& aiming = preferences_.settings().aiming;
    const QString name = targeting::methodName(aiming.method);
    return aiming.recentre ? tr("%1, re-centred").arg(name) : tr("%1, open loop").arg(name);
}

QString AimingPresenter::sunText() const {
    const AimingSettings& aiming = preferences_.settings().aiming;
    if (!aiming.place) {
        return tr("The Sun is not watched: latitude and longitude are not known.");
    }
    const targeting::SunPosition sun = targeting::sunPosition(*aiming.place, clock_.utcNow());
    const double height_deg = 90.0 - sun.zenith_angle.deg();
    const QString ha = preferences_.units().direction(sun.azimuth - station_.station().orientation);
    const QString where = height_deg < 0 ? tr("The Sun is down.")
                                         : tr("The Sun stands at HA %1, %2° high, when HA is oriented to true north.")
                                               .arg(ha)
                                               .arg(height_deg, 0, 'f', 0);
    return aiming.avoids_sun ? where : tr("Not watched. ") + where;
}

QString AimingPresenter::cableText() const {
    const double turns = instrument_.wound().value_or(Angle()).gon() / kGonPerTurn;
    const QString amount = QString::number(std::abs(turns), 'f', 2);
    return turns < 0 ? tr("The cable is wound %1 turns to the left.").arg(amount)
                     : tr("The cable is wound %1 turns to the right.").arg(amount);
}

void AimingPresenter::cableHangsFree() { instrument_.cableHangsFree(); }

}  // namespace pmts::app
