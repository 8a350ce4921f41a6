#pragma once

#include "pmts/core/clock.hpp"

#include <atomic>
#include <cstdint>

namespace pmts::core {

/// The switch between a time-critical micro-instruction and the live video: while it is closed the camera thread drops
/// frames at the source. The scheduler closes and opens it (instrument thread), the video sources read it
/// (camera thread), the status bar shows its counts (GUI thread): every member may be called from any thread.
class VideoGate {
public:
    struct Statistics {
        std::uint64_t pauses = 0;
        Duration longest{0};
        Duration total{0};
        std::uint64_t frames_dropped = 0;
    };

    /// Holds the gate closed for one micro-instruction; opens it again whatever happened.
    class Pause {
    public:
        Pause(VideoGate& gate, const Clock& clock);
        ~Pause();
        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;

    private:
        VideoGate& gate_;
        const Clock& clock_;
        Duration closed_at_;
    };

    [[nodiscard]] bool isOpen() const { return closed_.load(std::memory_order_acquire) == 0; }
    /// A source calls it for each frame it dropped because the gate was closed.
    void countDroppedFrame() { frames_dropped_.fetch_add(1, std::memory_order_relaxed); }
    [[nodiscard]] Statistics statistics() const;

private:
    std::atomic<int> closed_{0};
    std::atomic<std::uint64_t> pauses_{0};
    std::atomic<std::int64_t> longest_ns_{0};
    std::atomic<std::int64_t> total_ns_{0};
    std::atomic<std::uint64_t> frames_dropped_{0};
};

}  // namespace pmts::core
