#include "pmts/app/lab/self_calibration_view.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pmts::app {

namespace {

using calibration::RigParameter;
using enum calibration::RigParameter;

QString text(const char* sentence) { return QCoreApplication::translate("SelfCalibration", sentence); }

bool isAngle(RigParameter parameter) { return parameter == kYaw || parameter == kPitch || parameter == kTwist; }
bool isOffset(RigParameter parameter) {
    return parameter == kOffsetX || parameter == kOffsetY || parameter == kOffsetZ;
}
bool isPixel(RigParameter parameter) {
    return parameter == kFocalLength || parameter == kCentreX || parameter == kCentreY;
}

/// A number with its unit; `sign` puts a plus before what grew.
QString numberText(RigParameter parameter, double value, int more_decimals, bool sign, const UnitFormat& units) {
    const QString plus = sign && value >= 0 ? QStringLiteral("+") : QString();
    if (isAngle(parameter)) {
        return plus + units.angle(core::Angle::fromRad(value));
    }
    if (isOffset(parameter)) {
        return plus + text("%1 mm").arg(value * 1e3, 0, 'f', 1 + more_decimals);
    }
    if (isPixel(parameter)) {
        return plus + text("%1 px").arg(value, 0, 'f', 2 + more_decimals);
    }
    return plus + QString::number(value, 'f', 5);
}

QString deviationText(const calibration::ParameterEstimate& estimate, const UnitFormat& units) {
    if (!estimate.determinable()) {
        return text("not known");
    }
    const QString size = isAngle(estimate.parameter)
                             ? units.smallAngle(core::Angle::fromRad(*estimate.standard_deviation))
                             : numberText(estimate.parameter, *estimate.standard_deviation, 1, false, units);
    return QStringLiteral("± ") + size;
}

/// Of any lens with these names; nothing where the lens has no such number.
std::optional<double> valueIn(const camera::Rig& rig, RigParameter parameter) {
    const camera::Mount& mount = rig.mount;
    const auto* brown = std::get_if<camera::BrownLens>(&rig.lens.model());
    switch (parameter) {
        case kFocalLength:
            return rig.lens.focalLengthPx();
        case kCentreX:
            return rig.lens.principalPoint().x();
        case kCentreY:
            return rig.lens.principalPoint().y();
        case kYaw:
            return mount.yaw.rad();
        case kPitch:
            return mount.pitch.rad();
        case kTwist:
            return mount.twist.rad();
        case kOffsetX:
            return mount.offset_m.x();
        case kOffsetY:
            return mount.offset_m.y();
        case kOffsetZ:
            return mount.offset_m.z();
        case kK1:
            return brown ? std::optional(brown->k1) : std::nullopt;
        case kK2:
            return brown ? std::optional(brown->k2) : std::nullopt;
        case kK3:
            return brown ? std::optional(brown->k3) : std::nullopt;
        case kP1:
            return brown ? std::optional(brown->p1) : std::nullopt;
        case kP2:
            return brown ? std::optional(brown->p2) : std::nullopt;
    }
    return std::nullopt;
}

QString capitalised(QString words) {
    words[0] = words[0].toUpper();
    return words;
}

CalibratedParameter rowFor(RigParameter parameter, const camera::Rig& found, const camera::Rig& compared_with,
                           const UnitFormat& units) {
    const double value = valueIn(found, parameter).value_or(0.0);
    CalibratedParameter row{.name = capitalised(calibration::parameterWords(parameter)),
                            .value = numberText(parameter, value, 0, false, units),
                            .deviation = {},
                            .change = QStringLiteral("–"),
                            .held = false};
    if (const auto before = valueIn(compared_with, parameter)) {
        row.change = numberText(parameter, value - *before, 0, true, units);
    }
    return row;
}

template <class Use>
void eachPicture(const calibration::SelfCalibration& found, const std::vector<calibration::SweptSpot>& spots, Use use) {
    std::size_t index = 0;
    for (std::size_t spot = 0; spot < spots.size(); ++spot) {
        for (const calibration::SpotPicture& picture : spots[spot].pictures) {
            const bool outlier =
                std::find(found.outliers.begin(), found.outliers.end(), index) != found.outliers.end();
            use(picture.px, found.residuals_px[index], static_cast<int>(spot), outlier);
            ++index;
        }
    }
}

}  // namespace

SelfCalibrationView viewOf(const calibration::SelfCalibration& found,
                           const std::vector<calibration::SweptSpot>& spots, const camera::Rig& compared_with,
                           const UnitFormat& units) {
    SelfCalibrationView view;
    view.verdict = calibration::verdict(found);
    view.frame_px = {found.rig.width_px, found.rig.height_px};
    view.centre_px = {found.rig.lens.principalPoint().x(), found.rig.lens.principalPoint().y()};
    for (const calibration::ParameterEstimate& estimate : found.parameters) {
        CalibratedParameter row = rowFor(estimate.parameter, found.rig, compared_with, units);
        row.deviation = deviationText(estimate, units);
        view.parameters.push_back(row);
        view.correlated.append(row.name);
        view.symbols.append(calibration::parameterName(estimate.parameter).section(u' ', 0, 0));
    }
    for (const calibration::HeldParameter& held : found.held) {
        CalibratedParameter row = rowFor(held.parameter, found.rig, compared_with, units);
        row.deviation = text("kept");
        row.change = QStringLiteral("–");
        row.held = true;
        view.parameters.push_back(row);
    }
    for (Eigen::Index i = 0; i < found.correlation.rows(); ++i) {
        view.correlation.emplace_back();
        for (Eigen::Index j = 0; j < found.correlation.cols(); ++j) {
            view.correlation.back().push_back(found.correlation(i, j));
        }
    }
    eachPicture(found, spots,
                [&](const Eigen::Vector2d& px, const Eigen::Vector2d& residual_px, int spot, bool outlier) {
                    view.residuals.push_back(
                        {{px.x(), px.y()}, {residual_px.x(), residual_px.y()}, spot, outlier});
                });
    view.quality = text("%1 px in the fit, %2 px in pictures left out of it")
                       .arg(found.rms_px, 0, 'f', 3)
                       .arg(found.held_out_px, 0, 'f', 3);
    return view;
}

CalibrationRecord recordOf(const calibration::SelfCalibration& found,
                           const std::vector<calibration::SweptSpot>& spots) {
    CalibrationRecord record;
    record.method = CalibrationMethod::kSelfCalibration;
    record.utc = QDateTime::currentDateTimeUtc();
    record.rms_px = found.rms_px;
    record.held_out_px = found.held_out_px;
    record.remark = calibration::verdict(found).join(u' ');
    for (const calibration::ParameterEstimate& estimate : found.parameters) {
        if (estimate.standard_deviation) {
            record.standard_deviations[calibration::parameterName(estimate.parameter)] = *estimate.standard_deviation;
        }
    }
    eachPicture(found, spots, [&](const Eigen::Vector2d& px, const Eigen::Vector2d& residual_px, int, bool outlier) {
        record.residuals.push_back({.px = px, .residual_px = residual_px, .held_out = outlier});
    });
    return record;
}

}  // namespace pmts::app
