#include "pmts/app/desk/frame_feed.hpp"

#include <QAbstractEventDispatcher>
#include <QCoreApplication>

#include <algorithm>

namespace pmts::app {

namespace {

tl::unexpected<core::Error> noPicture() {
    return core::fail(core::ErrorKind::kCamera, QCoreApplication::translate("FrameFeed", "The camera gives no new picture."),
                      QCoreApplication::translate("FrameFeed", "Check the camera, then click the target again."));
}

}  // namespace

void FrameFeed::publish(const camera::FramePtr& frame) {
    const std::lock_guard lock(mutex_);
    newest_ = frame;
    const auto served = std::partition(waiters_.begin(), waiters_.end(), [&](const Waiter& waiter) {
        return frame->captured_at <= waiter.since;
    });
    for (auto waiter = served; waiter != waiters_.end(); ++waiter) {
        // A routine goes on in the thread that waits; one that ended meanwhile has its answer and ignores this.
        if (waiter->loop) {
            QMetaObject::invokeMethod(
                waiter->loop, [answer = waiter->answer, frame] { answer.complete(frame); }, Qt::QueuedConnection);
        }
    }
    waiters_.erase(served, waiters_.end());
}

core::Task<core::Result<camera::FramePtr>> FrameFeed::after(std::shared_ptr<FrameFeed> feed, core::Duration since,
                                                            core::Clock& clock, std::stop_token stop) {
    core::Completion<camera::FramePtr> wanted;
    {
        const std::lock_guard lock(feed->mutex_);
        if (feed->newest_ && feed->newest_->captured_at > since) {
            co_return feed->newest_;
        }
        feed->waiters_.push_back({.since = since, .loop = QAbstractEventDispatcher::instance(), .answer = wanted});
    }
    const core::Timer patience = clock.callAfter(kPatience, [wanted] { wanted.complete(noPicture()); });
    const std::stop_callback on_stop(stop, [wanted] { wanted.complete(core::cancelled()); });
    auto answer = wanted.answer();
    co_return co_await answer;
}

}  // namespace pmts::app
