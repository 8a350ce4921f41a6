#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"

#include <functional>
#include <memory>

namespace pmts::instrument {

class GeodimeterDriver;

struct PollerSettings {
    core::Duration interval =
        std::chrono::milliseconds(100);  ///< from one reading to the next; at least 5 a second are shown
    core::Duration longest_back_off = std::chrono::seconds(1);  ///< between readings that fail
    int failures_to_silence = 3;  ///< this many in a row: the instrument is silent
};

/// Keeps HA and VA fresh whenever the line is idle, at the lowest priority; what it reads goes out by the
/// driver's on_pointing. While a routine runs it keeps still, so that a command never waits for it longer
/// than one short read.
class PointingPoller {
public:
    /// Driver and clock outlive the poller.
    PointingPoller(GeodimeterDriver& driver, core::Clock& clock, PollerSettings settings = {});
    ~PointingPoller();
    PointingPoller(const PointingPoller&) = delete;
    PointingPoller& operator=(const PointingPoller&) = delete;

    void start();
    void stop();
    [[nodiscard]] bool isRunning() const;

    /// Connected means answering: several polls in a row had no answer. Said once until one is answered
    /// again.
    std::function<void(const core::Error&)> on_silence;

private:
    class Loop;
    GeodimeterDriver& driver_;
    core::Clock& clock_;
    PollerSettings settings_;
    std::shared_ptr<Loop> loop_;
};

}  // namespace pmts::instrument
