#pragma once

#include "pmts/camera/lens_file.hpp"

#include <vector>

namespace pmts::camera {

/// A lens in OpenCV's numbers, the common ground of the two formats; pixel centres are whole numbers.
struct LensNumbers {
    double fx = 0, fy = 0, cx = 0, cy = 0;
    std::vector<double> distortion;  ///< k1 k2 p1 p2 k3 k4 k5 k6, or k1 k2 k3 k4 of the fisheye
    bool fisheye = false;
    int width_px = 0, height_px = 0;
};

[[nodiscard]] core::Result<LensFile> lensFromNumbers(const LensNumbers& numbers);
[[nodiscard]] core::Result<LensNumbers> numbersOfLens(const Lens& lens, int width_px, int height_px);
/// 17 digits: comes back bit by bit.
[[nodiscard]] QByteArray exactNumber(double value);

}  // namespace pmts::camera
