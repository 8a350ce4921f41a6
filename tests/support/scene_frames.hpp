#pragma once

#include "pmts/core/task.hpp"
#include "pmts/simulator/scene_camera.hpp"

#include <functional>

namespace pmts::test {

/// A camera that draws a frame 40 ms after it was asked, as a live view gives them. `change` may alter each
/// picture: exposure drift, a covered lens, a swinging camera.
class SceneFrames {
public:
    SceneFrames(core::Clock& clock, std::shared_ptr<simulator::SceneCamera> camera)
        : clock_(clock), camera_(std::move(camera)) {}

    std::function<void(cv::Mat& picture)> change;
    int drawn = 0;

    [[nodiscard]] camera::FramePtr now() {
        auto frame = std::make_shared<camera::Frame>(camera_->draw(clock_.now()));
        frame->image = frame->image.clone();
        if (change) {
            change(frame->image);
        }
        ++drawn;
        return frame;
    }
    [[nodiscard]] core::Task<core::Result<camera::FramePtr>> after(core::Duration, std::stop_token stop) {
        auto slept = co_await core::sleepFor(clock_, std::chrono::milliseconds(40), stop);
        if (!slept) {
            co_return tl::unexpected(slept.error());
        }
        co_return now();
    }
    /// What a routine is given; this object outlives it.
    [[nodiscard]] auto source() {
        return [this](core::Duration since, std::stop_token stop) { return after(since, stop); };
    }

private:
    core::Clock& clock_;
    std::shared_ptr<simulator::SceneCamera> camera_;
};

}  // namespace pmts::test
