#pragma once

#include "pmts/camera/frame.hpp"
#include "pmts/core/clock.hpp"
#include "pmts/core/task.hpp"

#include <QPointer>

#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

namespace pmts::app {

/// Hands the pictures of the live view to a routine on another thread that waits for the next one.
class FrameFeed {
public:
    static constexpr core::Duration kPatience = std::chrono::seconds(3);

    void publish(const camera::FramePtr& frame);  ///< any thread
    /// The first frame exposed after `since`; kCamera when none comes within the patience, kCancelled on stop.
    /// Awaited on the clock's thread; any number of waiters.
    [[nodiscard]] static core::Task<core::Result<camera::FramePtr>> after(std::shared_ptr<FrameFeed> feed,
                                                                          core::Duration since, core::Clock& clock,
                                                                          std::stop_token stop);

private:
    struct Waiter {
        core::Duration since{0};
        QPointer<QObject> loop;  ///< of the waiting thread
        core::Completion<camera::FramePtr> answer;
    };

    std::mutex mutex_;
    camera::FramePtr newest_;
    std::vector<Waiter> waiters_;
};

}  // namespace pmts::app
