#include "spot_at.hpp"

#include <opencv2/core.hpp>

namespace pmts::app {

Eigen::Vector2d spotAt(const camera::FramePtr& frame, const Eigen::Vector2d& clicked_px,
                       const targeting::SnapSettings& settings) {
    try {
        const auto found = targeting::snapped(frame->image, clicked_px, settings);
        return found ? found->px : clicked_px;
    } catch (const cv::Exception&) {
        return clicked_px;
    }
}

}  // namespace pmts::app
