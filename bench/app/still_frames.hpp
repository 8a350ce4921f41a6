#pragma once

#include "pmts/camera/frame.hpp"

#include <opencv2/core/mat.hpp>

#include <utility>

namespace pmts::bench {

/// The same picture every time, drawn before: the video runs, the drawing costs nothing.
inline auto stillFrames(cv::Mat picture) {
    return [picture = std::move(picture)](core::Duration captured_at) {
        camera::Frame frame;
        frame.image = picture;
        frame.captured_at = captured_at;
        return frame;
    };
}

}  // namespace pmts::bench
