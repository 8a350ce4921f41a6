#pragma once

#include "pmts/camera/frame.hpp"

#include <Eigen/Core>

namespace pmts::app {

/// Sub-pixel place of the mark near a click; the click itself where no mark of a known kind is near. Takes a while: in
/// the pool.
[[nodiscard]] Eigen::Vector2d spotAt(const camera::FramePtr& frame, const Eigen::Vector2d& clicked_px);

}  // namespace pmts::app
