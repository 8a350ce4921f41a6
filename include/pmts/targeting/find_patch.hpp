#pragma once

#include "pmts/camera/frame.hpp"
#include "pmts/core/task.hpp"
#include "pmts/targeting/patch_matcher.hpp"

#include <functional>

namespace pmts::targeting {

/// The matcher as a routine awaits it: taking a patch and finding it again last longer than the instrument
/// thread may be busy.
struct FindPatch {
    std::function<core::Task<core::Result<Patch>>(camera::FramePtr frame, Eigen::Vector2d click_px)> take;
    std::function<core::Task<core::Result<Match>>(Patch patch, camera::FramePtr frame, Expectation expected)>
        find;
};

/// On the calling thread, at once: for tests and for programs without a thread to spare.
[[nodiscard]] FindPatch findHere(PatchMatcher matcher);
/// On a thread of Qt's global pool; the waiter goes on in the event loop of the thread that asked.
[[nodiscard]] FindPatch findInPool(PatchMatcher matcher);

}  // namespace pmts::targeting
