#pragma once

#include "pmts/camera/frame.hpp"
#include "pmts/targeting/patch_matcher.hpp"

#include <memory>
#include <mutex>
#include <optional>

namespace pmts::targeting {

/// Takes the patch of a click in Qt's pool while the surveyor still looks at HA and VA, so that the move need not wait
/// for it. One thread asks; what is not ready is simply absent.
class PatchAhead {
public:
    explicit PatchAhead(PatchMatcher matcher = PatchMatcher()) : matcher_(matcher) {}

    void begin(camera::FramePtr frame, const Eigen::Vector2d& click_px);
    /// Absent while it is being taken, for another click, and when there is nothing to be known again there: the routine
    /// that takes it then says why.
    [[nodiscard]] std::optional<Patch> taken(const camera::FramePtr& frame, const Eigen::Vector2d& click_px) const;

private:
    struct Slot {
        camera::FramePtr frame;
        Eigen::Vector2d click_px = Eigen::Vector2d::Zero();
        std::mutex mutex;
        std::optional<Patch> patch;  ///< guarded
    };

    PatchMatcher matcher_;
    std::shared_ptr<Slot> slot_;
};

}  // namespace pmts::targeting
