#include "frame_slot.hpp"

namespace pmts::video {
namespace {

constexpr core::Duration kRateWindow = std::chrono::seconds(2);

}  // namespace

unsigned FrameSlot::renew() {
    const std::lock_guard lock(mutex_);
    newest_.reset();
    taken_ = true;
    deliveries_.clear();
    return ++run_;
}

bool FrameSlot::put(camera::FramePtr frame, core::Duration delivered_at, unsigned run) {
    const std::lock_guard lock(mutex_);
    if (run != run_) {
        return false;
    }
    counts_.overtaken += newest_ && !taken_ ? 1 : 0;
    ++counts_.delivered;
    counts_.newest_age = delivered_at - frame->captured_at;
    newest_ = std::move(frame);
    deliveries_.push_back(delivered_at);
    while (deliveries_.front() < delivered_at - kRateWindow) {
        deliveries_.pop_front();
    }
    const bool tell = taken_ && !notice_under_way_;
    taken_ = false;
    notice_under_way_ = notice_under_way_ || tell;
    return tell;
}

camera::FramePtr FrameSlot::take() {
    const std::lock_guard lock(mutex_);
    taken_ = true;
    return newest_;
}

bool FrameSlot::noticeArrived() {
    const std::lock_guard lock(mutex_);
    notice_under_way_ = false;
    return newest_ != nullptr;
}

void FrameSlot::countLost(std::uint64_t frames) {
    const std::lock_guard lock(mutex_);
    counts_.lost += frames;
}

SourceStatistics FrameSlot::statistics(core::Duration at) const {
    const std::lock_guard lock(mutex_);
    SourceStatistics result = counts_;
    if (deliveries_.size() >= 2 && deliveries_.back() > at - kRateWindow) {
        const auto span = std::chrono::duration<double>(deliveries_.back() - deliveries_.front()).count();
        result.measured_rate_hz = span > 0.0 ? static_cast<double>(deliveries_.size() - 1) / span : 0.0;
    }
    return result;
}

}  // namespace pmts::video
