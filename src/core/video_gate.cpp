#include "pmts/core/video_gate.hpp"

namespace pmts::core {

VideoGate::Pause::Pause(VideoGate& gate, const Clock& clock)
    : gate_(gate), clock_(clock), closed_at_(clock.now()) {
    gate_.closed_.fetch_add(1, std::memory_order_acq_rel);
    gate_.pauses_.fetch_add(1, std::memory_order_relaxed);
}

VideoGate::Pause::~Pause() {
    const std::int64_t span_ns = (clock_.now() - closed_at_).count();
    gate_.total_ns_.fetch_add(span_ns, std::memory_order_relaxed);
    std::int64_t longest_ns = gate_.longest_ns_.load(std::memory_order_relaxed);
    while (span_ns > longest_ns && !gate_.longest_ns_.compare_exchange_weak(longest_ns, span_ns)) {
    }
    gate_.closed_.fetch_sub(1, std::memory_order_acq_rel);
}

VideoGate::Statistics VideoGate::statistics() const {
    return {.pauses = pauses_.load(std::memory_order_relaxed),
            .longest = Duration(longest_ns_.load(std::memory_order_relaxed)),
            .total = Duration(total_ns_.load(std::memory_order_relaxed)),
            .frames_dropped = frames_dropped_.load(std::memory_order_relaxed)};
}

}  // namespace pmts::core
