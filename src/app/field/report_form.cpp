#include "report_form.hpp"

#include <QCoreApplication>
#include <QRegularExpression>

namespace pmts::app {

namespace {

using targeting::MethodReportOptions;

constexpr int kLargestSide_px = 20000;

QString say(const char* text) { return QCoreApplication::translate("MethodReport", text); }

tl::unexpected<core::Error> unreadable(const QString& text, const QString& remedy) {
    return core::fail(core::ErrorKind::kBadInput, say("“%1” is not understood.").arg(text), remedy);
}

core::Result<double> pixels(const QString& text, double least, double most) {
    bool is_number = false;
    const double px = QString(text).remove(QStringLiteral("px")).trimmed().replace(u',', u'.').toDouble(&is_number);
    if (!is_number || !(px >= least && px <= most)) {
        return unreadable(text, say("Enter pixels between %1 and %2.").arg(least).arg(most));
    }
    return px;
}

/// Angle of a pixel: a decimal more than other angles have.
QString pixelAngleText(core::Angle angle, const UnitFormat& units) {
    return core::angleText(angle, units.angle_unit, core::usualDecimals(units.angle_unit) + 1);
}

core::Result<void> readPixelAngle(const QString& text, const UnitFormat& units, MethodReportOptions& options,
                                  core::Angle targeting::AveragePixelAngle::*part) {
    if (text.trimmed().isEmpty()) {
        options.pixel_angle_given = false;
        return {};
    }
    const auto angle = units.parseAngle(text);
    PMTS_TRY(angle);
    if (*angle == core::Angle()) {
        return unreadable(text, say("The angle of a pixel is not zero."));
    }
    options.camera.pixel_angle.*part = *angle;
    return {};
}



core::Result<void> readPixels(const QString& text, double least, double most, double& value) {
    const auto px = pixels(text, least, most);
    PMTS_TRY(px);
    value = *px;
    return {};
}

core::Result<void> readSide(const QString& text, int& value) {
    double px = 0;
    PMTS_TRY(readPixels(text, 1, kLargestSide_px, px));
    value = static_cast<int>(px);
    return {};
}

core::Result<void> readAngle(const QString& text, const UnitFormat& units, core::Angle& value) {
    const auto angle = units.parseAngle(text);
    PMTS_TRY(angle);
    value = *angle;
    return {};
}

core::Result<void> readLength(const QString& text, const UnitFormat& units, double& value_m) {
    const auto length_m = units.parseLengthM(text);
    PMTS_TRY(length_m);
    value_m = *length_m;
    return {};
}

QString number(double value) { return QString::number(value, 'f', 1); }

/// The numbers behind `--name`, when there are as many as wanted.
std::optional<std::vector<double>> argument(const QString& text, const char* name, std::size_t wanted) {
    const QRegularExpression form(QStringLiteral("--%1 ([-0-9.,x]+)").arg(QLatin1String(name)));
    const QStringList parts = form.match(text).captured(1).split(QRegularExpression(QStringLiteral("[,x]")));
    std::vector<double> values;
    for (const QString& part : parts) {
        bool is_number = false;
        values.push_back(part.toDouble(&is_number));
        if (!is_number) {
            return std::nullopt;
        }
    }
    return values.size() == wanted ? std::optional(values) : std::nullopt;
}

}  // namespace

MethodReportForm reportFormOf(const MethodReportOptions& options, RigOfReport rig, const UnitFormat& units) {
    using Field = ReportField;
    const targeting::ThesisCamera& camera = options.camera;
    const auto pixel_angle = [&](core::Angle angle) {
        return options.pixel_angle_given ? pixelAngleText(angle, units) : QString();
    };
    MethodReportForm form{.fields = {}, .on_handle = options.nominal_mount == camera::MountKind::kHandle, .rig = rig};
    form.fields = {{Field::kWidth, QString::number(options.width_px)},
                   {Field::kHeight, QString::number(options.height_px)},
                   {Field::kCentreX, number(camera.centre_px.x())},
                   {Field::kCentreY, number(camera.centre_px.y())},
                   {Field::kPhotoHa, units.direction(options.photo.ha)},
                   {Field::kPhotoVa, units.angle(options.photo.va)},
                   {Field::kF, number(camera.f_px)},
                   {Field::kRight, units.length(options.offset_right_m)},
                   {Field::kForward, units.length(camera.forward_m)},
                   {Field::kUp, units.length(camera.up_m)},
                   {Field::kPixelAcross, pixel_angle(camera.pixel_angle.horizontal)},
                   {Field::kPixelDown, pixel_angle(camera.pixel_angle.vertical)}};
    return form;
}

core::Result<void> readReportField(ReportField field, const QString& text, const UnitFormat& units,
                                   MethodReportOptions& options) {
    using Field = ReportField;
    targeting::ThesisCamera& camera = options.camera;
    switch (field) {
        case Field::kWidth: return readSide(text, options.width_px);
        case Field::kHeight: return readSide(text, options.height_px);
        case Field::kCentreX: return readPixels(text, -kLargestSide_px, kLargestSide_px, camera.centre_px.x());
        case Field::kCentreY: return readPixels(text, -kLargestSide_px, kLargestSide_px, camera.centre_px.y());
        case Field::kF: return readPixels(text, 1, 1e6, camera.f_px);
        case Field::kPhotoHa: return readAngle(text, units, options.photo.ha);
        case Field::kPhotoVa: return readAngle(text, units, options.photo.va);
        case Field::kRight: return readLength(text, units, options.offset_right_m);
        case Field::kForward: return readLength(text, units, camera.forward_m);
        case Field::kUp: return readLength(text, units, camera.up_m);
        case Field::kPixelAcross:
            return readPixelAngle(text, units, options, &targeting::AveragePixelAngle::horizontal);
        case Field::kPixelDown: return readPixelAngle(text, units, options, &targeting::AveragePixelAngle::vertical);
    }
    return {};
}

QString argumentsOf(const MethodReportOptions& options) {
    const targeting::ThesisCamera& camera = options.camera;
    return QStringLiteral("--image %1x%2 --centre %3,%4").arg(options.width_px).arg(options.height_px)
               .arg(camera.centre_px.x(), 0, 'f', 2).arg(camera.centre_px.y(), 0, 'f', 2) +
           QStringLiteral(" --pointing %1,%2 --f %3").arg(options.photo.ha.gon(), 0, 'f', 5)
               .arg(options.photo.va.gon(), 0, 'f', 5).arg(camera.f_px, 0, 'f', 2) +
           QStringLiteral(" --offset %1,%2,%3").arg(options.offset_right_m, 0, 'f', 4)
               .arg(camera.forward_m, 0, 'f', 4).arg(camera.up_m, 0, 'f', 4);
}

bool takeArguments(const QString& text, MethodReportOptions& options) {
    const auto image = argument(text, "image", 2);
    const auto centre = argument(text, "centre", 2);
    const auto pointing = argument(text, "pointing", 2);
    const auto f_px = argument(text, "f", 1);
    const auto offset_m = argument(text, "offset", 3);
    if (!image || !centre || !pointing || !f_px || !offset_m || (*image)[0] < 1 || (*image)[1] < 1 || (*f_px)[0] < 1) {
        return false;
    }
    options.width_px = static_cast<int>((*image)[0]);
    options.height_px = static_cast<int>((*image)[1]);
    options.camera.centre_px = {(*centre)[0], (*centre)[1]};
    options.photo = {core::Angle::fromGon((*pointing)[0]), core::Angle::fromGon((*pointing)[1])};
    options.camera.f_px = (*f_px)[0];
    options.offset_right_m = (*offset_m)[0];
    options.camera.forward_m = (*offset_m)[1];
    options.camera.up_m = (*offset_m)[2];
    return true;
}

}  // namespace pmts::app
