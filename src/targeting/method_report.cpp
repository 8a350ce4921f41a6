#include "pmts/targeting/method_report.hpp"

#include "method_tables_text.hpp"
#include "pmts/targeting/pixel_to_pointing.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pmts::targeting {
namespace {

using core::Angle;
using core::Result;
using geometry::Pointing;
using Targets = std::vector<ListedTarget>;
using Compute = std::function<Result<Pointing>(std::size_t index, const ListedTarget& target)>;

QString sentence(const char* text) { return QCoreApplication::translate("MethodReport", text); }

/// An error the thesis states in hundredths of a gon.
QString stated(double gon, const MethodReportOptions& options) {
    const int decimals = std::max(0, core::usualDecimals(options.angle_unit) - 2);
    return core::angleText(Angle::fromGon(gon), options.angle_unit, decimals);
}

MethodTable tabulated(Method method, const Targets& targets, const Compute& compute) {
    MethodTable table;
    table.method = method;
    double sum2_ha = 0, sum2_va = 0;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        MethodRow row{.computed = compute(i, targets[i]), .error_ha = {}, .error_va = {}};
        if (row.computed) {
            const Pointing& observed = targets[i].observed.pointing;
            row.error_ha = core::normalizedSigned(row.computed->ha - observed.ha);
            row.error_va = core::normalizedSigned(row.computed->va - observed.va);
            table.largest_ha = std::max(table.largest_ha, core::abs(row.error_ha));
            table.largest_va = std::max(table.largest_va, core::abs(row.error_va));
            sum2_ha += std::pow(row.error_ha.gon(), 2);
            sum2_va += std::pow(row.error_va.gon(), 2);
            ++table.computed;
        }
        table.rows.push_back(std::move(row));
    }
    if (table.computed > 0) {
        table.rms_ha = Angle::fromGon(std::sqrt(sum2_ha / table.computed));
        table.rms_va = Angle::fromGon(std::sqrt(sum2_va / table.computed));
    }
    return table;
}

using Printed = std::optional<Pointing> ListedTarget::*;

void comparePrinted(MethodTable& table, const Targets& targets, Printed printed) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
        MethodRow& row = table.rows[i];
        if (const auto& other = targets[i].*printed; other && row.computed) {
            row.off_printed_ha = core::normalizedSigned(row.computed->ha - other->ha);
            row.off_printed_va = row.computed->va - other->va;
            const Angle off = std::max(core::abs(*row.off_printed_ha), core::abs(*row.off_printed_va));
            table.off_printed = std::max(table.off_printed.value_or(Angle()), off);
        }
    }
}

/// A straight line through (pixel, angle) pairs: angle of a pixel, and the pixel that has the photo's angle.
struct PixelLine {
    Angle per_px;
    double centre_px = 0.0;
};

std::optional<PixelLine> fittedLine(const std::vector<std::pair<double, Angle>>& pairs) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const auto& [px, angle] : pairs) {
        n += 1;
        sx += px;
        sy += angle.gon();
        sxx += px * px;
        sxy += px * angle.gon();
    }
    const double spread = n * sxx - sx * sx;
    if (n < 2 || spread <= 0 || n * sxy == sx * sy) {
        return std::nullopt;
    }
    const double slope = (n * sxy - sx * sy) / spread;
    return PixelLine{Angle::fromGon(slope), -(sy - slope * sx) / n / slope};
}

/// How somebody's printed APA column was made: it is linear in the pixels, so that two numbers a direction
/// say everything.
std::optional<ThesisCamera> cameraOfPrintedApa(const Targets& targets, const MethodReportOptions& options) {
    std::vector<std::pair<double, Angle>> columns, rows;
    for (const ListedTarget& target : targets) {
        if (target.printed_apa) {
            columns.emplace_back(target.px.x(),
                                 core::normalizedSigned(target.printed_apa->ha - options.photo.ha));
            rows.emplace_back(target.px.y(), target.printed_apa->va - options.photo.va);
        }
    }
    const auto across = fittedLine(columns);
    const auto down = fittedLine(rows);
    if (!across || !down) {
        return std::nullopt;
    }
    ThesisCamera camera = options.camera;
    camera.pixel_angle = {across->per_px, down->per_px};
    camera.centre_px = {across->centre_px, down->centre_px};
    return camera;
}

/// Eq. 6.1-6.2 with the outermost targets of the list.
Result<ThesisCamera> cameraOfExtremes(const Targets& targets, const MethodReportOptions& options) {
    const auto by = [](int axis) {
        return [axis](const ListedTarget& a, const ListedTarget& b) { return a.px[axis] < b.px[axis]; };
    };
    const auto [left, right] = std::minmax_element(targets.begin(), targets.end(), by(0));
    const auto [upper, lower] = std::minmax_element(targets.begin(), targets.end(), by(1));
    const auto sighted = [](const ListedTarget& target) {
        return SightedPixel{target.px, target.observed.pointing};
    };
    return averagePixelAngle(sighted(*left), sighted(*right), sighted(*upper), sighted(*lower))
        .map([&](const AveragePixelAngle& angle) {
            ThesisCamera camera = options.camera;
            camera.pixel_angle = angle;
            return camera;
        });
}

QString apaSetting(const ThesisCamera& camera, const QString& from, core::AngleUnit unit) {
    const auto pixel = [unit](Angle angle) { return core::angleText(angle, unit, core::usualDecimals(unit) + 1); };
    return sentence("%1 per pixel across, %2 down, about pixel %3, %4 (%5)")
        .arg(pixel(camera.pixel_angle.horizontal), pixel(camera.pixel_angle.vertical))
        .arg(camera.centre_px.x(), 0, 'f', 1)
        .arg(camera.centre_px.y(), 0, 'f', 1)
        .arg(from);
}

MethodTable apaTable(const Targets& targets, const MethodReportOptions& options) {
    Result<ThesisCamera> camera = options.camera;
    QString from = sentence("as given");
    if (!options.pixel_angle_given) {
        const auto printed = cameraOfPrintedApa(targets, options);
        camera = printed ? Result<ThesisCamera>(*printed) : cameraOfExtremes(targets, options);
        from = printed ? sentence("as the printed column was made")
                       : sentence("measured between the outermost targets, eq. 6.1-6.2");
    }
    MethodTable table = tabulated(Method::kApa, targets, [&](std::size_t, const ListedTarget& target) {
        return camera.map([&](const ThesisCamera& c) { return apa(c, options.photo, target.px); });
    });
    table.title = sentence("APA, average pixel angle (table 6.1)");
    table.known_error =
        sentence("known error: up to %1 on the thesis's photo; a pixel is 20 % wider at the centre")
            .arg(stated(1.47, options));
    table.setting = camera ? apaSetting(*camera, from, options.angle_unit) : camera.error().sentence();
    comparePrinted(table, targets, &ListedTarget::printed_apa);
    return table;
}

QString cameraSetting(const ThesisCamera& camera) {
    return sentence("f = %1 px, centre %2, %3")
        .arg(camera.f_px, 0, 'f', 1)
        .arg(camera.centre_px.x(), 0, 'f', 1)
        .arg(camera.centre_px.y(), 0, 'f', 1);
}

MethodTable tpaTable(const Targets& targets, const MethodReportOptions& options) {
    MethodTable table = tabulated(Method::kTpa, targets, [&](std::size_t, const ListedTarget& target) {
        return Result<Pointing>(tpa(options.camera, options.photo, target.px));
    });
    table.title = sentence("TPA, tangent pixel angle (table 6.2)");
    table.known_error =
        sentence("known error: up to %1 on the thesis's photo; no distortion, no offset").arg(stated(1.76, options));
    table.setting = cameraSetting(options.camera);
    comparePrinted(table, targets, &ListedTarget::printed_tpa);
    return table;
}

QString offsetSetting(const ThesisCamera& camera) {
    return cameraSetting(camera) + sentence(", offset %1 m forward, %2 m up")
                                       .arg(camera.forward_m, 0, 'f', 3)
                                       .arg(camera.up_m, 0, 'f', 3);
}

MethodTable oatpaTable(const Targets& targets, const MethodReportOptions& options) {
    MethodTable table = tabulated(Method::kOatpa, targets, [&](std::size_t, const ListedTarget& target) {
        return oatpa(options.camera, options.photo, target.px, target.observed.slope_distance_m);
    });
    table.title = sentence("OATPA, offset added TPA (table 6.3)");
    table.known_error =
        sentence("known error: up to %1 on the thesis's photo; no distortion").arg(stated(1.71, options));
    table.setting = offsetSetting(options.camera);
    comparePrinted(table, targets, &ListedTarget::printed_oatpa);
    return table;
}

MethodTable rectifiedTable(const Targets& targets, const MethodReportOptions& options) {
    std::optional<camera::RadialTableLens> lens = options.table;
    QString from = sentence("the distortion table as given");
    if (!lens && (options.fit || options.rig)) {
        lens = tableFromLens(options.fit ? options.fit->rig.lens : options.rig->lens, options.camera.centre_px,
                             std::hypot(options.width_px, options.height_px));
        from = sentence("a distortion table made from the %1 lens, every 30 px about the photo's centre")
                   .arg(options.fit ? sentence("fitted") : sentence("calibrated"));
    }
    const auto nothing = core::fail(core::ErrorKind::kUndefined, sentence("There is no distortion table."),
                                    sentence("Measure one, or fit the rig."));
    MethodTable table = tabulated(Method::kRectifiedOatpa, targets,
                                  [&](std::size_t, const ListedTarget& target) -> Result<Pointing> {
                                      if (!lens) {
                                          return nothing;
                                      }
                                      return rectifiedOatpa(options.camera, *lens, options.photo, target.px,
                                                            target.observed.slope_distance_m);
                                  });
    table.title = sentence("Rectified OATPA (table 6.4)");
    table.known_error =
        sentence("known error: the thesis prints up to %1; angles are still added, not rotated")
            .arg(stated(0.06, options));
    table.setting = lens ? from + ", " + offsetSetting(options.camera) : nothing.value().sentence();
    return table;
}

camera::Rig nominalRig(const MethodReportOptions& options) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = options.camera.f_px,
                                              .cx_px = options.camera.centre_px.x(),
                                              .cy_px = options.camera.centre_px.y()});
    rig.mount = {.kind = options.nominal_mount,
                 .offset_m = {options.offset_right_m, options.camera.forward_m, options.camera.up_m}};
    if (options.nominal_mount == camera::MountKind::kHandle) {
        rig.mount.pitch = Angle::fromGon(100) - options.photo.va;  // the photo's centre was read there
    }
    rig.width_px = options.width_px;
    rig.height_px = options.height_px;
    return rig;
}

Result<Pointing> rigorous(const camera::Rig& rig, const MethodReportOptions& options,
                          const ListedTarget& target) {
    return PixelToPointing(rig).pointingForPixel(target.px, options.photo, target.observed.slope_distance_m);
}

MethodTable rigorousTable(const Targets& targets, const MethodReportOptions& options) {
    const camera::Rig rig = options.fit ? options.fit->rig : options.rig ? *options.rig : nominalRig(options);
    MethodTable table = tabulated(Method::kRigorous, targets, [&](std::size_t, const ListedTarget& target) {
        return rigorous(rig, options, target);
    });
    table.title = sentence("Rigorous: the ray is rotated");
    if (options.fit) {
        table.known_error = sentence("known error: the noise of the clicks, on the targets it was fitted to");
        table.setting = sentence("rig fitted to these targets, rms %1 px, largest %2 px")
                            .arg(options.fit->rms_px, 0, 'f', 2)
                            .arg(options.fit->largest_px, 0, 'f', 2);
    } else if (options.rig) {
        table.known_error = sentence("known error: the noise of the clicks and of the rig's calibration");
        table.setting = sentence("the calibrated rig in use");
    } else {
        table.known_error = sentence("known error: all of the lens's distortion; the rig is not calibrated");
        table.setting = sentence("nominal camera: ") + offsetSetting(options.camera);
    }
    return table;
}

MethodTable leftOutTable(const Targets& targets, const MethodReportOptions& options) {
    MethodTable table = tabulated(Method::kRigorous, targets, [&](std::size_t i, const ListedTarget& target) {
        return rigorous(options.fit->without[i], options, target);
    });
    table.left_one_out = true;
    table.title = sentence("Rigorous, left one out");
    table.known_error = sentence("what a new target may expect");
    table.setting = sentence("each target by the rig fitted to all the others");
    return table;
}

}  // namespace

std::vector<MethodTable> runMethods(const Targets& targets, const MethodReportOptions& options) {
    std::vector<MethodTable> tables{apaTable(targets, options), tpaTable(targets, options),
                                    oatpaTable(targets, options), rectifiedTable(targets, options),
                                    rigorousTable(targets, options)};
    if (options.fit && options.fit->without.size() == targets.size()) {
        tables.push_back(leftOutTable(targets, options));
    }
    return tables;
}

QString methodReport(const Targets& targets, const MethodReportOptions& options) {
    return textOfTables(targets, options, runMethods(targets, options));
}

}  // namespace pmts::targeting
