#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/camera/picture_meters.hpp"
#include "pmts/core/clock.hpp"
#include "pmts/video/camera_control.hpp"

#include <QImage>
#include <QString>

namespace pmts::app {

/// Words and numbers of the camera page, as people read them.
struct ExposureAdvice {
    DeviceState state = DeviceState::kGood;
    QString text;
};

[[nodiscard]] QString controlUnit(video::CameraControl control);
[[nodiscard]] QString controlText(const video::CameraControlState& control);
[[nodiscard]] QString limitsText(const video::ControlRange& range);
[[nodiscard]] QString rateText(double rate_hz);  ///< `30`, `29.97`
[[nodiscard]] QString sharpnessText(double sharpness, double best);
/// What the shares of burnt out and black pixels mean, and what to do with what this camera has.
[[nodiscard]] ExposureAdvice adviceOn(const camera::PictureMeters& picture, bool has_exposure, bool has_gain);
[[nodiscard]] double secondsOf(core::Duration span);
[[nodiscard]] QImage burntImage(const cv::Mat& bgr);

}  // namespace pmts::app
