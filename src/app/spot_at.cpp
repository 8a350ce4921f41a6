#include "spot_at.hpp"

#include "pmts/targeting/snap.hpp"

#include <opencv2/core.hpp>

namespace pmts::app {

Eigen::Vector2d spotAt(const camera::FramePtr& frame, const Eigen::Vector2d& clicked_px) {
    try {
        const auto found = targeting::snapped(frame->image, clicked_px);
        return found ? found->px : clicked_px;
    } catch (const cv::Exception&) {
        return clicked_px;
    }
}

}  // namespace pmts::app
