#pragma once

#include "pmts/video/video_source.hpp"

namespace pmts::app {

/// A camera that shows the pictures of a recording. GUI thread only.
class ReplaySource final : public video::VideoSource {
    Q_OBJECT
public:
    using video::VideoSource::VideoSource;

    void show(const camera::FramePtr& frame);

    void start(const video::VideoFormat& wanted) override;
    void stop() override {}
    [[nodiscard]] video::SourceAddress address() const override;
    [[nodiscard]] video::SourceState state() const override { return video::SourceState::kRunning; }
    [[nodiscard]] video::SourceStatistics statistics() const override;
    [[nodiscard]] video::DeviceReport report() const override;
    [[nodiscard]] camera::FramePtr newestFrame() const override { return newest_; }

private:
    camera::FramePtr newest_;
    std::uint64_t shown_ = 0;
    double rate_hz_ = 0.0;  ///< of the kept pictures
};

}  // namespace pmts::app
