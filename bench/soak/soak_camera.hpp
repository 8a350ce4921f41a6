#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/video_gate.hpp"
#include "pmts/video/video_source.hpp"

namespace pmts::soak {

/// A camera in virtual time that obeys the gate as the real ones do: while it is closed a picture is dropped and counted.
class SoakCamera final : public video::VideoSource {
public:
    SoakCamera(core::Clock& time, core::VideoGate& gate) : time_(time), gate_(gate) {}

    void start(const video::VideoFormat&) override {
        setState(video::SourceState::kRunning);
        tick();
    }
    void stop() override {
        next_.cancel();
        setState(video::SourceState::kStopped);
    }
    [[nodiscard]] video::SourceAddress address() const override {
        return {.kind = video::SourceKind::kSimulated, .location = {}, .name = QStringLiteral("Soak camera")};
    }
    [[nodiscard]] video::SourceState state() const override { return state_; }
    [[nodiscard]] video::SourceStatistics statistics() const override { return {}; }
    [[nodiscard]] camera::FramePtr newestFrame() const override { return frame_; }

    [[nodiscard]] std::uint64_t shown() const { return shown_; }

private:
    void setState(video::SourceState state) {
        state_ = state;
        Q_EMIT stateChanged(state);
    }
    void tick() {
        next_ = time_.callAfter(std::chrono::seconds(1), [this] { tick(); });
        if (!gate_.isOpen()) {
            gate_.countDroppedFrame();
            return;
        }
        auto frame = std::make_shared<camera::Frame>();
        frame->image = picture_;
        frame->captured_at = time_.now();
        frame->sequence = ++shown_;
        frame_ = frame;
        Q_EMIT frameReady();
    }

    core::Clock& time_;
    core::VideoGate& gate_;
    core::Timer next_;
    cv::Mat picture_{36, 64, CV_8UC3, cv::Scalar::all(90)};
    video::SourceState state_ = video::SourceState::kStopped;
    camera::FramePtr frame_;
    std::uint64_t shown_ = 0;
};

}  // namespace pmts::soak
