#include "pmts/app/lab/calibration_report.hpp"

#include "pmts/calibration/rig_fit.hpp"
#include "pmts/camera/lens_difference.hpp"

#include <Eigen/Geometry>
#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::app {

namespace {

QString say(const char* text) { return QCoreApplication::translate("CalibrationReport", text); }

QString dateText(const QDateTime& utc) { return utc.isValid() ? utc.toUTC().toString(QStringLiteral("yyyy-MM-dd HH:mm 'UTC'")) : say("unknown"); }

/// Numbers of a lens with the names calibration::parameterName() gives the same ones.
struct LensNumbersOf {
    std::vector<std::pair<QString, double>> numbers;

    template <class FocalLens>
    void focal(const FocalLens& l) {
        numbers = {{QStringLiteral("f [px]"), l.f_px}, {QStringLiteral("cx [px]"), l.cx_px}, {QStringLiteral("cy [px]"), l.cy_px}};
    }
    void add(const char* name, double value) { numbers.emplace_back(QLatin1String(name), value); }

    void operator()(const camera::BrownLens& l) {
        focal(l);
        add("k1", l.k1), add("k2", l.k2), add("k3", l.k3), add("p1", l.p1), add("p2", l.p2);
    }
    void operator()(const camera::RationalLens& l) {
        focal(l);
        add("k1", l.k1), add("k2", l.k2), add("k3", l.k3), add("k4", l.k4), add("k5", l.k5), add("k6", l.k6), add("p1", l.p1), add("p2", l.p2);
    }
    void operator()(const camera::FisheyeLens& l) {
        focal(l);
        add("k1", l.k1), add("k2", l.k2), add("k3", l.k3), add("k4", l.k4);
    }
    void operator()(const camera::RadialTableLens& l) {
        numbers = {{QStringLiteral("cx [px]"), l.cx_px}, {QStringLiteral("cy [px]"), l.cy_px}};
        add("rows of the table", static_cast<double>(l.rows.size()));
    }
};

QString deviationOf(const RigProfile& profile, const QString& name, double factor = 1.0, int decimals = -1) {
    if (!profile.calibration) {
        return {};
    }
    const auto found = profile.calibration->standard_deviations.find(name);
    if (found == profile.calibration->standard_deviations.end()) {
        return {};
    }
    const double value = found->second * factor;
    return QStringLiteral("± ") + (decimals < 0 ? QString::number(value, 'g', 2) : QString::number(value, 'f', decimals));
}

void addParameters(CalibrationReport& report, const RigProfile& profile) {
    LensNumbersOf visit;
    std::visit(visit, profile.rig.lens.model());
    for (const auto& [name, value] : visit.numbers) {
        report.parameters.push_back({name, QString::number(value, 'g', 7), deviationOf(profile, name)});
    }
    const camera::Mount& mount = profile.rig.mount;
    const auto angle = [&](const char* name, core::Angle value) {
        constexpr double kMgonPerRad = 200000.0 / M_PI;
        report.parameters.push_back({say(name) + QStringLiteral(" [mgon]"), QString::number(value.gon() * 1000, 'f', 1),
                                     deviationOf(profile, QLatin1String(name) + QStringLiteral(" [rad]"), kMgonPerRad, 1)});
    };
    angle("yaw", mount.yaw);
    angle("pitch", mount.pitch);
    angle("twist", mount.twist);
    const char* const kOffsets[] = {"Xo", "Yo", "Zo"};
    for (int axis = 0; axis < 3; ++axis) {
        const QString name = QLatin1String(kOffsets[axis]);
        report.parameters.push_back({name + QStringLiteral(" [mm]"), QString::number(mount.offset_m[axis] * 1000, 'f', 1),
                                     deviationOf(profile, name + QStringLiteral(" [m]"), 1000, 1)});
    }
}

void addFacts(CalibrationReport& report, const RigProfile& profile, const UnitFormat&) {
    const auto add = [&report](const QString& name, const QString& value) {
        if (!value.isEmpty()) {
            report.facts.emplace_back(name, value);
        }
    };
    add(say("Camera"), profile.use ? useText(*profile.use) : say("belongs to no camera"));
    add(say("Picture"), QStringLiteral("%1x%2 px").arg(profile.rig.width_px).arg(profile.rig.height_px));
    add(say("Mount"), profile.rig.mount.kind == camera::MountKind::kTelescope ? say("on the telescope") : say("on the handle"));
    if (!profile.calibration) {
        return add(say("Method"), say("not calibrated"));
    }
    const CalibrationRecord& record = *profile.calibration;
    add(say("Method"), methodText(record.method));
    add(say("Date"), dateText(record.utc));
    add(say("Instrument"), record.instrument);
    add(say("Temperature"), record.temperature_c ? say("%1 °C").arg(*record.temperature_c, 0, 'f', 1) : QString());
    add(say("Residuals"), record.rms_px > 0 ? say("%1 px rms over coordinates").arg(record.rms_px, 0, 'f', 3) : QString());
    add(say("Held out"), record.held_out_px ? say("%1 px rms over coordinates the fit did not see").arg(*record.held_out_px, 0, 'f', 3) : QString());
    add(say("Remark"), record.remark);
}

/// The lens itself, walked along the row of its principal point to the farther edge: whatever its model is.
void addCurves(CalibrationReport& report, const camera::Rig& rig) {
    constexpr int kSteps = 120;
    const Eigen::Vector2d centre = rig.lens.principalPoint();
    const double f_px = rig.lens.focalLengthPx();
    const bool to_right = centre.x() < rig.width_px / 2.0;
    const double reach_px = to_right ? rig.width_px - 1 - centre.x() : centre.x();
    const auto axis = rig.lens.cameraFromPixel(centre);
    double last_gon = 0.0;
    for (int i = 0; i <= kSteps && axis; ++i) {
        const double r_px = reach_px * i / kSteps;
        const auto ray = rig.lens.cameraFromPixel(centre + Eigen::Vector2d(to_right ? r_px : -r_px, 0));
        if (!ray) {
            break;
        }
        const double gon = core::Angle::fromRad(std::atan2(axis->cross(*ray).norm(), axis->dot(*ray))).gon();
        report.angle_curve.emplace_back(r_px, gon);
        report.ideal_curve.emplace_back(r_px, core::Angle::fromRad(std::atan(r_px / f_px)).gon());
        if (i > 0) {
            const double step_px = reach_px / kSteps;
            report.width_curve.emplace_back(r_px - step_px / 2, (gon - last_gon) / step_px);
        }
        last_gon = gon;
    }
}

void addChecks(CalibrationReport& report, const RigProfile& profile) {
    for (auto check = profile.checks.rbegin(); check != profile.checks.rend(); ++check) {
        report.checks.push_back({dateText(check->utc), check->target,
                                 say("%1 px, %2 mgon rms (limits %3 px, %4 mgon)").arg(check->rms_px, 0, 'f', 2).arg(check->rms.gon() * 1000, 0, 'f', 1)
                                     .arg(check->limit_px, 0, 'f', 2).arg(check->limit.gon() * 1000, 0, 'f', 0),
                                 check->passed ? say("passed") : say("failed")});
    }
}

QString comparison(const RigProfile& profile) {
    if (!profile.previous || profile.previous->rig.width_px != profile.rig.width_px) {
        return {};
    }
    const auto lens = camera::lensDifference(profile.previous->rig.lens, profile.rig.lens, profile.rig.width_px, profile.rig.height_px);
    const Eigen::Vector3d moved_mm = (profile.rig.mount.offset_m - profile.previous->rig.mount.offset_m) * 1000;
    const QString when = profile.previous->calibration ? dateText(profile.previous->calibration->utc) : say("before");
    const QString lens_text = lens ? say("the lens differs by %1 px rms").arg(lens->rms_px, 0, 'f', 2) : say("the lenses cannot be compared");
    return say("Against the calibration of %1: %2; offsets by %3, %4, %5 mm.").arg(when, lens_text)
        .arg(moved_mm.x(), 0, 'f', 1).arg(moved_mm.y(), 0, 'f', 1).arg(moved_mm.z(), 0, 'f', 1);
}

}  // namespace

CalibrationReport calibrationReport(const RigProfile& profile, const UnitFormat& units) {
    CalibrationReport report;
    report.title = profile.name;
    report.image_px = {profile.rig.width_px, profile.rig.height_px};
    const Eigen::Vector2d centre = profile.rig.lens.principalPoint();
    report.centre_px = {centre.x(), centre.y()};
    addFacts(report, profile, units);
    addParameters(report, profile);
    addCurves(report, profile.rig);
    addChecks(report, profile);
    if (profile.calibration) {
        report.residuals = profile.calibration->residuals;
    }
    report.compared = comparison(profile);
    return report;
}

QString calibrationReportText(const CalibrationReport& report) {
    QStringList lines{report.title};
    for (const auto& [name, value] : report.facts) {
        lines.append(name + QStringLiteral(": ") + value);
    }
    for (const auto& parameter : report.parameters) {
        lines.append(QStringLiteral("%1 = %2 %3").arg(parameter.name, parameter.value, parameter.deviation).trimmed());
    }
    if (!report.compared.isEmpty()) {
        lines.append(report.compared);
    }
    for (const auto& check : report.checks) {
        lines.append(QStringLiteral("%1  %2  %3  %4").arg(check.date, check.target, check.result, check.state));
    }
    return lines.join(u'\n');
}

}  // namespace pmts::app
