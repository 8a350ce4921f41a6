#pragma once

#include "pmts/core/clock.hpp"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>

namespace pmts::video {

struct Tick {
    std::uint64_t number = 0;
    core::Duration due{0};
};

/// Ticks at absolute times: no drift, however long the work between them takes. A late reader gets the missed
/// ticks one after the other, as from a camera's few buffers; beyond that they are skipped and their numbers
/// with them.
class TickPacer {
public:
    void start(double rate_hz);
    /// The next tick, waiting at most `limit`; nullopt when it is not due by then or interrupt() was called.
    [[nodiscard]] std::optional<Tick> wait(core::Duration limit);
    void interrupt();  ///< any thread

private:
    static constexpr int kBuffers = 4;

    std::mutex mutex_;
    std::condition_variable woken_;
    bool interrupted_ = false;
    core::Duration origin_{0};
    core::Duration period_{0};
    std::uint64_t next_ = 0;
};

}  // namespace pmts::video
