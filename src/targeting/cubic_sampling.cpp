#include "cubic_sampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pmts::targeting {
namespace {

/// Catmull-Rom weights of the four neighbours of a place `t` beyond the second.
std::array<float, 4> cubicWeights(float t) {
    const float t2 = t * t;
    const float t3 = t2 * t;
    return {-0.5f * t3 + t2 - 0.5f * t, 1.5f * t3 - 2.5f * t2 + 1.0f, -1.5f * t3 + 2.0f * t2 + 0.5f * t,
            0.5f * t3 - 0.5f * t2};
}

float cubicAt(const cv::Mat& picture, float x, float y) {
    const float left = std::floor(x);
    const float top = std::floor(y);
    const auto across = cubicWeights(x - left);
    const auto down = cubicWeights(y - top);
    std::array<int, 4> columns{};
    for (int i = 0; i < 4; ++i) {
        columns[i] = std::clamp(static_cast<int>(left) + i - 1, 0, picture.cols - 1);
    }
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i) {
        const auto* row = picture.ptr<float>(std::clamp(static_cast<int>(top) + i - 1, 0, picture.rows - 1));
        sum += down[i] * (across[0] * row[columns[0]] + across[1] * row[columns[1]] +
                          across[2] * row[columns[2]] + across[3] * row[columns[3]]);
    }
    return sum;
}

}  // namespace

cv::Mat cubicSampled(const cv::Mat& picture, const cv::Mat& places) {
    // Far outside is as good as just outside, and keeps the whole pixel within an int.
    const float most_x = static_cast<float>(picture.cols) + 2.0f;
    const float most_y = static_cast<float>(picture.rows) + 2.0f;
    cv::Mat values(places.size(), CV_32F);
    for (int row = 0; row < places.rows; ++row) {
        const auto* place = places.ptr<cv::Vec2f>(row);
        auto* value = values.ptr<float>(row);
        for (int column = 0; column < places.cols; ++column) {
            value[column] = cubicAt(picture, std::clamp(place[column][0], -2.0f, most_x),
                                    std::clamp(place[column][1], -2.0f, most_y));
        }
    }
    return values;
}

}  // namespace pmts::targeting
