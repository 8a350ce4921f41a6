#pragma once

#include "pmts/core/clock.hpp"

#include <deque>
#include <functional>
#include <string>
#include <string_view>

namespace pmts::simulator {

/// One direction of a serial line: bytes come out when their last bit would have arrived, ten bits a byte.
/// They are handed out line by line (at each CR and at the end of what was put in), so a timer serves many
/// bytes.
class PacedLine {
public:
    PacedLine(core::Clock& clock, std::function<void(std::string_view)> deliver);

    void setByteTime(core::Duration per_byte) { per_byte_ = per_byte; }  ///< 0: at once, inside put()
    /// `then` runs after the last byte was delivered; the first bit leaves not before `not_before`.
    void put(std::string_view bytes, core::Duration not_before = {}, std::function<void()> then = {});
    void clear();  ///< bytes on the way are lost, and so are their `then`
    [[nodiscard]] bool idle() const { return pending_.empty(); }

private:
    struct Segment {
        std::string bytes;
        core::Duration due;
        std::function<void()> then;
    };

    void deliverDue();
    void arm();

    core::Clock& clock_;
    std::function<void(std::string_view)> deliver_;
    core::Duration per_byte_{0};
    core::Duration free_at_{0};
    std::deque<Segment> pending_;
    core::Timer timer_;
    bool delivering_ = false;
};

}  // namespace pmts::simulator
