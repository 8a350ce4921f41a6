#pragma once

#include <opencv2/core.hpp>

#include <algorithm>

namespace pmts::simulator {

/// Natural noise: octaves of smooth random fields, each half as wide and `persistence` as strong as the one
/// before.
struct NoiseShape {
    double widest_px = 64.0;  ///< size of the largest blotches
    int octaves = 5;
    double persistence = 0.6;
};

/// A field with mean about 0 and standard deviation about 1; CV_32F.
[[nodiscard]] cv::Mat noiseField(cv::Size size, const NoiseShape& shape, cv::RNG& rng);

enum class Grain { kBlotches, kFine };  ///< widest 110 and 6 px

/// A piece of a large noise tile made once, from a random place, mirrored where it ends: a texture's noise
/// for the price of a table. Values are in 1/32 standard deviation.
class GrainPatch {
public:
    /// `zoom` 2 makes the blotches half as wide.
    GrainPatch(Grain grain, double zoom, cv::RNG& rng);

    [[nodiscard]] const schar* row(int row) const { return tile_.ptr<schar>(folded(row, offset_.y)); }
    [[nodiscard]] int column(int col) const { return folded(col, offset_.x); }
    [[nodiscard]] double at(int y, int x) const { return row(y)[column(x)] / 32.0; }

private:
    [[nodiscard]] int folded(int at, int offset) const {
        const int period = 2 * tile_.cols;
        const int along = (((at * step_q8_) >> 8) + offset) % period;
        return along < tile_.cols ? along : period - 1 - along;
    }

    cv::Mat tile_;
    cv::Point offset_;
    int step_q8_;
};

/// Multiplies an 8-bit BGR image by `light` * (1 + strength * noise).
void shadeBy(cv::Mat& image, const GrainPatch& grain, double strength, double light = 1.0);

}  // namespace pmts::simulator
