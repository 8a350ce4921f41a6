#include "qt_camera_controls.hpp"

#include <QCamera>

#include <algorithm>
#include <cmath>

namespace pmts::video {
namespace {

using Feature = QCamera::Feature;

constexpr double kMillisecond_s = 1e-3;

/// Qt answers -1 or nonsense where the backend knows nothing.
bool isRange(double minimum, double maximum) { return minimum > 0.0 && maximum > minimum; }

bool hasAutomatic(const QCamera& camera) { return camera.isExposureModeSupported(QCamera::ExposureAuto); }

void addExposure(const QCamera& camera, std::vector<CameraControlState>& all) {
    const double minimum_ms = static_cast<double>(camera.minimumExposureTime()) / kMillisecond_s;
    const double maximum_ms = static_cast<double>(camera.maximumExposureTime()) / kMillisecond_s;
    if (camera.supportedFeatures().testFlag(Feature::ManualExposureTime) && isRange(minimum_ms, maximum_ms)) {
        const double value_ms = std::max(0.0, static_cast<double>(camera.exposureTime()) / kMillisecond_s);
        all.push_back({{CameraControl::kExposure, minimum_ms, maximum_ms, 0.1, std::clamp(10.0, minimum_ms, maximum_ms),
                        hasAutomatic(camera), true},
                       {CameraControl::kExposure, camera.exposureMode() != QCamera::ExposureManual, value_ms}});
    }
}

void addGain(const QCamera& camera, std::vector<CameraControlState>& all) {
    const double minimum = camera.minimumIsoSensitivity(), maximum = camera.maximumIsoSensitivity();
    if (camera.supportedFeatures().testFlag(Feature::IsoSensitivity) && isRange(minimum, maximum)) {
        all.push_back({{CameraControl::kGain, minimum, maximum, 1.0, minimum, true, true},
                       {CameraControl::kGain, camera.manualIsoSensitivity() < 0, static_cast<double>(camera.isoSensitivity())}});
    }
}

void addWhiteBalance(const QCamera& camera, std::vector<CameraControlState>& all) {
    if (camera.supportedFeatures().testFlag(Feature::ColorTemperature)) {
        all.push_back({{CameraControl::kWhiteBalance, 2000.0, 10000.0, 50.0, 5600.0,
                        camera.isWhiteBalanceModeSupported(QCamera::WhiteBalanceAuto), true},
                       {CameraControl::kWhiteBalance, camera.whiteBalanceMode() == QCamera::WhiteBalanceAuto,
                        static_cast<double>(camera.colorTemperature())}});
    }
}

void addFocus(const QCamera& camera, std::vector<CameraControlState>& all) {
    if (camera.supportedFeatures().testFlag(Feature::FocusDistance) &&
        camera.isFocusModeSupported(QCamera::FocusModeManual)) {
        all.push_back({{CameraControl::kFocus, 0.0, 1.0, 0.01, 1.0, camera.isFocusModeSupported(QCamera::FocusModeAuto), true},
                       {CameraControl::kFocus, camera.focusMode() != QCamera::FocusModeManual,
                        static_cast<double>(camera.focusDistance())}});
    }
}

void addZoom(const QCamera& camera, std::vector<CameraControlState>& all) {
    const double minimum = static_cast<double>(camera.minimumZoomFactor());
    const double maximum = static_cast<double>(camera.maximumZoomFactor());
    if (isRange(minimum, maximum)) {
        all.push_back({{CameraControl::kZoom, minimum, maximum, 0.05, minimum, false, true},
                       {CameraControl::kZoom, false, static_cast<double>(camera.zoomFactor())}});
    }
}

}  // namespace

std::vector<CameraControlState> qtControls(const QCamera& camera) {
    std::vector<CameraControlState> all;
    addExposure(camera, all);
    addGain(camera, all);
    addWhiteBalance(camera, all);
    addFocus(camera, all);
    addZoom(camera, all);
    return all;
}

void setQtControl(QCamera& camera, const ControlValue& wish) {
    const auto states = qtControls(camera);
    const auto known =
        std::ranges::find(states, wish.control, [](const CameraControlState& state) { return state.range.control; });
    if (known == states.end()) {
        return;
    }
    ControlValue next = allowed(known->range, wish);
    if (wish.hold) {
        next = {.control = wish.control, .automatic = false, .value = known->value.value};
    }
    const auto value = static_cast<float>(next.value);
    switch (wish.control) {
        case CameraControl::kExposure:
            camera.setExposureMode(next.automatic ? QCamera::ExposureAuto : QCamera::ExposureManual);
            next.automatic ? camera.setAutoExposureTime()
                           : camera.setManualExposureTime(static_cast<float>(next.value * kMillisecond_s));
            return;
        case CameraControl::kGain:
            next.automatic ? camera.setAutoIsoSensitivity()
                           : camera.setManualIsoSensitivity(static_cast<int>(std::lround(next.value)));
            return;
        case CameraControl::kWhiteBalance:
            camera.setWhiteBalanceMode(next.automatic ? QCamera::WhiteBalanceAuto : QCamera::WhiteBalanceManual);
            if (!next.automatic) {
                camera.setColorTemperature(static_cast<int>(std::lround(next.value)));
            }
            return;
        case CameraControl::kFocus:
            camera.setFocusMode(next.automatic ? QCamera::FocusModeAuto : QCamera::FocusModeManual);
            if (!next.automatic) {
                camera.setFocusDistance(value);
            }
            return;
        case CameraControl::kZoom: camera.setZoomFactor(value); return;
    }
}

}  // namespace pmts::video
