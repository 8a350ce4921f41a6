#include "pmts/targeting/find_patch.hpp"

#include <QThreadPool>

namespace pmts::targeting {
namespace {

template <class T>
core::Task<core::Result<T>> here(std::function<core::Result<T>()> work) {
    co_return work();
}

template <class T>
core::Task<core::Result<T>> inPool(std::function<core::Result<T>()> work) {
    const core::Completion<T> completion;
    // Lives on the asking thread and carries the answer back to it; only that thread completes.
    const auto asker = std::make_shared<QObject>();
    QThreadPool::globalInstance()->start([work, completion, asker] {
        auto done = work();
        QMetaObject::invokeMethod(
            asker.get(), [completion, done] { completion.complete(done); }, Qt::QueuedConnection);
    });
    auto answer = completion.answer();
    co_return co_await answer;
}

/// The matcher with its two jobs done by `run`, which takes a job without arguments.
template <class Run>
FindPatch through(PatchMatcher matcher, Run run) {
    return {.take =
                [matcher, run](camera::FramePtr frame, Eigen::Vector2d click_px) {
                    return run(std::function([=] { return matcher.take(frame->image, click_px); }));
                },
            .find =
                [matcher, run](Patch patch, camera::FramePtr frame, Expectation expected) {
                    return run(std::function([=] { return matcher.find(patch, frame->image, expected); }));
                }};
}

}  // namespace

FindPatch findHere(PatchMatcher matcher) {
    return through(matcher, []<class T>(std::function<core::Result<T>()> work) { return here<T>(work); });
}

FindPatch findInPool(PatchMatcher matcher) {
    return through(matcher, []<class T>(std::function<core::Result<T>()> work) { return inPool<T>(work); });
}

}  // namespace pmts::targeting
