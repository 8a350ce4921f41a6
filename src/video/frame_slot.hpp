#pragma once

#include "pmts/camera/frame.hpp"
#include "pmts/video/video_source.hpp"

#include <deque>
#include <mutex>

namespace pmts::video {

/// Where the worker leaves the newest frame and others take it. Any thread.
class FrameSlot {
public:
    /// Empties the slot for a new run: frames of an older one that still arrive are refused. Returns the
    /// run's number.
    [[nodiscard]] unsigned renew();
    /// Puts a frame, replacing the one before. True when the receivers must be told: the last one told of was
    /// taken and no notice is on its way.
    [[nodiscard]] bool put(camera::FramePtr frame, core::Duration delivered_at, unsigned run);
    [[nodiscard]] camera::FramePtr take();
    /// The notice put() asked for has reached its thread. True when a frame waits there, also one of a newer
    /// run.
    [[nodiscard]] bool noticeArrived();
    void countLost(std::uint64_t frames);
    [[nodiscard]] SourceStatistics statistics(core::Duration at) const;

private:
    mutable std::mutex mutex_;
    unsigned run_ = 0;
    camera::FramePtr newest_;
    bool taken_ = true;
    bool notice_under_way_ = false;
    SourceStatistics counts_;
    std::deque<core::Duration> deliveries_;  ///< of the last two seconds
};

}  // namespace pmts::video
