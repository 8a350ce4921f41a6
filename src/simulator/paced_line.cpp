#include "paced_line.hpp"

#include <algorithm>

namespace pmts::simulator {

PacedLine::PacedLine(core::Clock& clock, std::function<void(std::string_view)> deliver)
    : clock_(clock), deliver_(std::move(deliver)) {}

void PacedLine::put(std::string_view bytes, core::Duration not_before, std::function<void()> then) {
    free_at_ = std::max({free_at_, clock_.now(), not_before});
    do {
        const std::size_t end = std::min(bytes.find('\r'), bytes.size() - 1) + 1;
        const std::string_view line = bytes.empty() ? bytes : bytes.substr(0, end);
        bytes.remove_prefix(line.size());
        free_at_ += per_byte_ * static_cast<std::int64_t>(line.size());
        pending_.push_back({std::string(line), free_at_, {}});
    } while (!bytes.empty());
    pending_.back().then = std::move(then);
    deliverDue();
}

void PacedLine::clear() {
    pending_.clear();
    timer_.cancel();
    free_at_ = core::Duration{0};
}

void PacedLine::deliverDue() {
    if (delivering_) {
        return;  // called from a delivery: the loop below goes on
    }
    delivering_ = true;
    while (!pending_.empty() && pending_.front().due <= clock_.now()) {
        const Segment segment = std::move(pending_.front());
        pending_.pop_front();
        if (!segment.bytes.empty()) {
            deliver_(segment.bytes);
        }
        if (segment.then) {
            segment.then();
        }
    }
    delivering_ = false;
    arm();
}

void PacedLine::arm() {
    if (pending_.empty()) {
        timer_.cancel();
        return;
    }
    timer_ = clock_.callAfter(pending_.front().due - clock_.now(), [this] { deliverDue(); });
}

}  // namespace pmts::simulator
