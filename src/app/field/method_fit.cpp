#include "pmts/app/field/method_fit.hpp"

#include "pmts/calibration/rig_fit.hpp"

namespace pmts::app {

namespace {

QString parameterLine(const calibration::ParameterEstimate& estimate) {
    return QStringLiteral("%1 %2 +- %3")
        .arg(calibration::parameterName(estimate.parameter))
        .arg(estimate.value, 0, 'f', 4)
        .arg(estimate.determinable() ? QString::number(*estimate.standard_deviation, 'f', 4)
                                     : QStringLiteral("not determinable"));
}

camera::Rig startOf(const targeting::MethodReportOptions& options) {
    camera::Rig start;
    start.lens = camera::Lens(camera::BrownLens{.f_px = options.camera.f_px,
                                                .cx_px = options.camera.centre_px.x(),
                                                .cy_px = options.camera.centre_px.y()});
    start.mount.kind = options.nominal_mount;
    start.mount.offset_m = {options.offset_right_m, options.camera.forward_m, options.camera.up_m};
    start.width_px = options.width_px;
    start.height_px = options.height_px;
    return start;
}

}  // namespace

core::Result<targeting::FittedRig> fitToTargets(const std::vector<targeting::ListedTarget>& targets,
                                                const targeting::MethodReportOptions& options, const FitProgress& go_on) {
    std::vector<calibration::Sighting> sightings;
    for (const targeting::ListedTarget& target : targets) {
        sightings.push_back({.px = target.px, .at = options.photo, .target = target.observed});
    }
    const camera::Rig start = startOf(options);
    const int all = static_cast<int>(targets.size()) + 1;
    if (go_on && !go_on(0, all)) {
        return core::cancelled();
    }
    const auto fit = calibration::fitRig(sightings, start, calibration::thesisParameters());
    PMTS_TRY(fit);
    auto without = calibration::fitWithoutEach(
        sightings, start, calibration::thesisParameters(),
        [&go_on, all](std::size_t done) { return !go_on || go_on(static_cast<int>(done) + 1, all); });
    PMTS_TRY(without);
    targeting::FittedRig fitted{.rig = fit->rig, .rms_px = fit->rms_px, .largest_px = fit->largest_px, .parameters = {},
                                .without = *std::move(without)};
    for (const calibration::ParameterEstimate& estimate : fit->parameters) {
        fitted.parameters.append(parameterLine(estimate));
    }
    return fitted;
}

}  // namespace pmts::app
