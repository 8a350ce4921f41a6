#include "pmts/camera/scaled_picture.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace pmts::camera {

cv::Mat scaledPicture(const cv::Mat& picture, int width_px, int height_px) {
    if (picture.cols == width_px && picture.rows == height_px) {
        return picture;
    }
    const double scale =
        std::max(static_cast<double>(width_px) / picture.cols, static_cast<double>(height_px) / picture.rows);
    const int left = static_cast<int>(std::lround((picture.cols - width_px / scale) / 2.0));
    const int top = static_cast<int>(std::lround((picture.rows - height_px / scale) / 2.0));
    const cv::Rect kept(left, top, picture.cols - 2 * left, picture.rows - 2 * top);
    cv::Mat scaled;
    cv::resize(picture(kept), scaled, {width_px, height_px}, 0, 0, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
    return scaled;
}

}  // namespace pmts::camera
