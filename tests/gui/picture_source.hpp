#pragma once

#include "pmts/video/video_source.hpp"

#include <opencv2/core.hpp>

namespace pmts::test {

/// A light grey wall, 1280 x 720.
inline cv::Mat greyPicture() { return {720, 1280, CV_8UC3, cv::Scalar::all(190)}; }

/// A camera that shows one picture, taken with the telescope at HA 100 gon, VA 98 gon.
class PictureSource : public video::VideoSource {
public:
    explicit PictureSource(const cv::Mat& picture = greyPicture()) {
        auto frame = std::make_shared<camera::Frame>();
        frame->image = picture;
        frame->pointing = geometry::Pointing{core::Angle::fromGon(100), core::Angle::fromGon(98)};
        frame->sequence = 1;
        frame_ = frame;
    }
    void start(const video::VideoFormat&) override { Q_EMIT frameReady(); }
    void stop() override {}
    [[nodiscard]] video::SourceAddress address() const override { return {}; }
    [[nodiscard]] video::SourceState state() const override { return video::SourceState::kRunning; }
    [[nodiscard]] video::SourceStatistics statistics() const override { return {}; }
    [[nodiscard]] camera::FramePtr newestFrame() const override { return frame_; }

private:
    camera::FramePtr frame_;
};

}  // namespace pmts::test
