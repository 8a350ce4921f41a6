#include "camera_words.hpp"

#include "pmts/app/lab/camera_presenter.hpp"

#include <QCoreApplication>

namespace pmts::app {

namespace {

constexpr double kBurntTolerated = 0.005;  // lamps and glints
constexpr double kBurntMuch = 0.05;
constexpr double kBlackMuch = 0.25;
constexpr double kDarkMean = 40.0;

QString say(const char* text) { return QCoreApplication::translate("CameraWords", text); }

QString percent(double share) { return QString::number(share * 100.0, 'f', share < 0.0995 ? 1 : 0); }

QString number(double value) { return QString::number(value, 'g', 4); }

QString withUnit(double value, video::CameraControl control) {
    const QString unit = controlUnit(control);
    return unit.isEmpty() ? number(value) : QStringLiteral("%1 %2").arg(number(value), unit);
}

}  // namespace

QString controlName(video::CameraControl control) {
    switch (control) {
        case video::CameraControl::kExposure: return say("Exposure");
        case video::CameraControl::kGain: return say("Gain");
        case video::CameraControl::kWhiteBalance: return say("White balance");
        case video::CameraControl::kFocus: return say("Focus");
        case video::CameraControl::kZoom: return say("Zoom");
    }
    return {};
}

QString controlUnit(video::CameraControl control) {
    switch (control) {
        case video::CameraControl::kExposure: return QStringLiteral("ms");
        case video::CameraControl::kWhiteBalance: return QStringLiteral("K");
        default: return {};
    }
}

QString controlText(const video::CameraControlState& control) {
    const QString value = withUnit(control.value.value, control.range.control);
    if (!control.range.has_value) {
        return control.value.automatic ? say("automatic") : say("fixed");
    }
    return control.value.automatic ? say("%1, automatic").arg(value) : value;
}

QString limitsText(const video::ControlRange& range) {
    return range.has_value ? say("%1 to %2, usually %3")
                                 .arg(number(range.minimum), withUnit(range.maximum, range.control), number(range.usual))
                           : QString();
}

QString rateText(double rate_hz) { return QString::number(rate_hz, 'g', 4); }

QString sharpnessText(double sharpness, double best) {
    const QString now = QString::number(sharpness, 'f', 2);
    if (best <= 0.0) {
        return now;
    }
    return say("%1, %2 % of the best").arg(now).arg(qRound(100.0 * sharpness / best));
}

ExposureAdvice adviceOn(const camera::PictureMeters& picture, bool has_exposure, bool has_gain) {
    const QString less = has_exposure ? say("shorten the exposure") : has_gain ? say("lower the gain") : say("shade the lens");
    const QString more = has_exposure ? say("expose longer") : has_gain ? say("raise the gain") : say("bring more light");
    if (picture.burnt_share > kBurntTolerated) {
        return {picture.burnt_share > kBurntMuch ? DeviceState::kFailed : DeviceState::kWarning,
                say("%1 % of the picture is burnt out: %2.").arg(percent(picture.burnt_share), less)};
    }
    if (picture.black_share > kBlackMuch) {
        return {DeviceState::kWarning, say("%1 % of the picture is black: %2.").arg(percent(picture.black_share), more)};
    }
    if (picture.mean_luma < kDarkMean) {
        return {DeviceState::kWarning, say("The picture is dark: %1.").arg(more)};
    }
    return {DeviceState::kGood, say("The exposure is right: %1 % burnt out, %2 % black.")
                                    .arg(percent(picture.burnt_share), percent(picture.black_share))};
}

double secondsOf(core::Duration span) { return std::chrono::duration<double>(span).count(); }

QImage burntImage(const cv::Mat& bgr) {
    const cv::Mat mask = camera::burntMask(bgr);
    return QImage(mask.data, mask.cols, mask.rows, static_cast<qsizetype>(mask.step), QImage::Format_Grayscale8).copy();
}

}  // namespace pmts::app
