#include "scene_canvas.hpp"

#include <algorithm>

namespace pmts::simulator {

void Canvas::write(const std::string& text, const Patch_m& patch, const cv::Scalar& colour) {
    constexpr int kFont = cv::FONT_HERSHEY_TRIPLEX;
    int baseline = 0;
    const cv::Size unit = cv::getTextSize(text, kFont, 1.0, 1, &baseline);
    const double scale = std::min(patch.width / texel_m_ / unit.width, patch.height / texel_m_ / unit.height);
    const int thickness = std::max(1, cvRound(1.6 * scale));
    const double left_px = (patch.left + patch.width / 2) / texel_m_ - unit.width * scale / 2;
    const double base_px =
        image_.rows - (patch.bottom + patch.height / 2) / texel_m_ + unit.height * scale / 2;
    cv::putText(image_, text, {cvRound(left_px), cvRound(base_px)}, kFont, scale, colour, thickness,
                cv::LINE_AA);
}

}  // namespace pmts::simulator
