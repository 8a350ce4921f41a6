#include "capture_device.hpp"
#include "tick_pacer.hpp"

namespace pmts::video {
namespace {

class SimulatedDevice final : public CaptureDevice {
public:
    explicit SimulatedDevice(FramePainter painter) : painter_(std::move(painter)) {}

    core::Result<void> open(const VideoFormat& wanted) override {
        pacer_.start(wanted.rate_hz);
        return {};
    }
    core::Result<std::optional<Shot>> next(core::Duration limit) override {
        const auto tick = pacer_.wait(limit);
        if (!tick) {
            return std::nullopt;
        }
        shot_ = {tick->number, tick->due};
        return shot_;
    }
    camera::Frame picture() override { return painter_(shot_.captured_at); }
    void close() override {}
    void interrupt() override { pacer_.interrupt(); }

private:
    FramePainter painter_;
    TickPacer pacer_;
    Shot shot_;
};

}  // namespace

std::unique_ptr<CaptureDevice> makeSimulatedDevice(FramePainter painter) {
    return std::make_unique<SimulatedDevice>(std::move(painter));
}

}  // namespace pmts::video
