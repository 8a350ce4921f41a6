#pragma once

#include "pmts/camera/frame.hpp"
#include "pmts/targeting/snap.hpp"

#include <Eigen/Core>

namespace pmts::app {

/// Sub-pixel place of the mark near a click; the click itself where no mark of a known kind is near. Takes a while
/// with the usual settings: in the pool.
[[nodiscard]] Eigen::Vector2d spotAt(const camera::FramePtr& frame, const Eigen::Vector2d& clicked_px,
                                     const targeting::SnapSettings& settings = {});

}  // namespace pmts::app
