#pragma once

#include "pmts/camera/frame.hpp"

namespace pmts::test {

/// A grey frame with one blue (B = 255) pixel at (column, row).
inline camera::FramePtr frameWithBluePixel(int column, int row, int width = 1280, int height = 720) {
    auto frame = std::make_shared<camera::Frame>();
    frame->image = cv::Mat(height, width, CV_8UC3, cv::Scalar(90, 90, 90));
    frame->image.at<cv::Vec3b>(row, column) = cv::Vec3b(255, 0, 0);
    return frame;
}

}  // namespace pmts::test
