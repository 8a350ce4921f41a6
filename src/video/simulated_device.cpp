#include "capture_device.hpp"
#include "tick_pacer.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::video {
namespace {

/// Takes a picture at every tick of the wanted rate; what is on it is drawn when somebody wants it.
class PacedDevice : public CaptureDevice {
public:
    core::Result<std::optional<Shot>> next(core::Duration limit) override {
        const auto tick = pacer_.wait(limit);
        if (!tick) {
            return std::nullopt;
        }
        shot_ = {tick->number, tick->due};
        return shot_;
    }
    void close() override {}
    void interrupt() override { pacer_.interrupt(); }

protected:
    void startTicking(double rate_hz) { pacer_.start(rate_hz); }
    [[nodiscard]] core::Duration capturedAt() const { return shot_.captured_at; }

private:
    TickPacer pacer_;
    Shot shot_;
};

class SimulatedDevice final : public PacedDevice {
public:
    explicit SimulatedDevice(FramePainter painter) : painter_(std::move(painter)) {}

    core::Result<void> open(const VideoFormat& wanted) override {
        startTicking(wanted.rate_hz);
        return {};
    }
    camera::Frame picture() override { return painter_(capturedAt()); }

private:
    FramePainter painter_;
};

constexpr double kExposureUsual_ms = 10.0;
constexpr double kSharpFocus = 62.0;

struct SimulatedMode {
    QSize size;
    double fastest_hz;
};
constexpr SimulatedMode kModes[] = {
    {{640, 480}, 60.0}, {{1280, 720}, 30.0}, {{1920, 1080}, 30.0}, {{2560, 1440}, 10.0}};
constexpr double kRates_hz[] = {60.0, 30.0, 15.0, 10.0, 5.0};

/// The controls of a webcam: exposure and focus can look after themselves.
std::vector<CameraControlState> simulatedControls() {
    return {{{CameraControl::kExposure, 0.5, 100.0, 0.5, kExposureUsual_ms, true, true},
             {CameraControl::kExposure, true, kExposureUsual_ms}},
            {{CameraControl::kGain, 1.0, 16.0, 0.25, 1.0, false, true}, {CameraControl::kGain, false, 1.0}},
            {{CameraControl::kFocus, 0.0, 100.0, 1.0, kSharpFocus, true, true}, {CameraControl::kFocus, true, kSharpFocus}}};
}

/// A camera with modes and controls that act on what the painter draws.
class AdjustableDevice final : public PacedDevice {
public:
    explicit AdjustableDevice(ExposurePainter painter) : painter_(std::move(painter)) {
        for (const SimulatedMode& mode : kModes) {
            for (const double rate_hz : kRates_hz) {
                if (rate_hz <= mode.fastest_hz) {
                    formats_.push_back({mode.size, rate_hz, QStringLiteral("BGR")});
                }
            }
        }
    }

    core::Result<void> open(const VideoFormat& wanted) override {
        const auto off = [&wanted](const VideoFormat& offer) {
            const QSize apart = offer.size - wanted.size;
            return (std::abs(apart.width()) + std::abs(apart.height())) * 1000.0 + std::abs(offer.rate_hz - wanted.rate_hz);
        };
        format_ = *std::ranges::min_element(formats_, {}, off);
        setting_.size = format_.size;
        startTicking(format_.rate_hz);
        return {};
    }
    camera::Frame picture() override { return painter_(capturedAt(), setting_); }

    DeviceReport report() override { return {format_, formats_, controls_}; }
    void setControl(const ControlValue& wish) override {
        const auto known = std::ranges::find(controls_, wish.control, [](const auto& control) { return control.range.control; });
        if (known == controls_.end()) {
            return;
        }
        ControlValue next = wish.hold ? known->value : allowed(known->range, wish);
        next.automatic = next.automatic && !wish.hold;
        if (next.automatic) {
            next.value = known->range.usual;  // the scene is lit for it and stands still
        }
        known->value = next;
        setting_.exposure_ms = controls_[0].value.value;
        setting_.gain = controls_[1].value.value;
        setting_.out_of_focus = std::abs(controls_[2].value.value - kSharpFocus);
    }

private:
    ExposurePainter painter_;
    std::vector<VideoFormat> formats_;
    VideoFormat format_;
    std::vector<CameraControlState> controls_ = simulatedControls();
    SimulatedExposure setting_;
};

}  // namespace

std::unique_ptr<CaptureDevice> makeSimulatedDevice(ExposurePainter painter) {
    return std::make_unique<AdjustableDevice>(std::move(painter));
}

std::unique_ptr<CaptureDevice> makeSimulatedDevice(FramePainter painter) {
    return std::make_unique<SimulatedDevice>(std::move(painter));
}

}  // namespace pmts::video
