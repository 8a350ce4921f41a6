#include "scene_atlas.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

namespace pmts::simulator {
namespace {

constexpr int kBorder = 2;
constexpr int kSmallestLevel = 4;
constexpr double kSoftness_px =
    0.65;  // hard edges would jump from pixel to pixel: a sensor integrates, reading does not
constexpr int kUsualWidth = 4096;
constexpr int kLargestTexture = 8192;
constexpr int kLargestHeight = 32000;  // remap addresses pixels as 16-bit numbers

cv::Mat asTexture(const cv::Mat& texture) {
    if (texture.empty() || texture.type() != CV_8UC3) {
        throw std::logic_error("a texture is a non-empty 8-bit BGR image");
    }
    const double shrink = static_cast<double>(kLargestTexture) / std::max(texture.cols, texture.rows);
    if (shrink >= 1.0) {
        return texture;
    }
    cv::Mat smaller;
    cv::resize(texture, smaller, {}, shrink, shrink, cv::INTER_AREA);
    return smaller;
}

std::vector<cv::Size> levelSizes(cv::Size size) {
    std::vector<cv::Size> sizes{size};
    while (std::min(size.width, size.height) >= 2 * kSmallestLevel) {
        size = {size.width / 2, size.height / 2};
        sizes.push_back(size);
    }
    return sizes;
}

/// Places rectangles on shelves of decreasing height; the first shelf starts below the dark pixels.
class Shelves {
public:
    explicit Shelves(int width) : width_(width) {}

    cv::Rect place(cv::Size size) {
        const cv::Size outer(size.width + 2 * kBorder, size.height + 2 * kBorder);
        if (x_ + outer.width > width_) {
            y_ += shelf_height_;
            x_ = shelf_height_ = 0;
        }
        const cv::Rect inner({x_ + kBorder, y_ + kBorder}, size);
        x_ += outer.width;
        shelf_height_ = std::max(shelf_height_, outer.height);
        return inner;
    }
    [[nodiscard]] int height() const { return y_ + shelf_height_; }

private:
    int width_;
    int x_ = 0;
    int y_ = kBorder;
    int shelf_height_ = 0;
};

void paint(cv::Mat& image, const cv::Mat& texture, const TextureAtlas::Levels& levels) {
    cv::Mat level = texture;
    for (const cv::Rect& place : levels) {
        if (level.size() != place.size()) {
            cv::Mat half;
            cv::resize(level, half, place.size(), 0, 0, cv::INTER_AREA);
            level = half;
        }
        cv::Mat soft;
        cv::GaussianBlur(level, soft, {3, 3}, kSoftness_px, 0.0, cv::BORDER_REPLICATE);
        const cv::Rect outer(place.x - kBorder, place.y - kBorder, place.width + 2 * kBorder,
                             place.height + 2 * kBorder);
        cv::Mat target = image(outer);
        cv::copyMakeBorder(soft, target, kBorder, kBorder, kBorder, kBorder, cv::BORDER_REPLICATE);
    }
}

struct Wanted {
    std::size_t entry;
    std::size_t level;
    cv::Size size;
};

std::vector<Wanted> tallestFirst(const std::vector<cv::Mat>& textures) {
    std::vector<Wanted> all;
    for (std::size_t entry = 0; entry < textures.size(); ++entry) {
        const std::vector<cv::Size> sizes = levelSizes(textures[entry].size());
        for (std::size_t level = 0; level < sizes.size(); ++level) {
            all.push_back({entry, level, sizes[level]});
        }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Wanted& a, const Wanted& b) { return a.size.height > b.size.height; });
    return all;
}

}  // namespace

TextureAtlas::TextureAtlas(const std::vector<cv::Mat>& textures) {
    std::map<const void*, std::size_t> known;
    std::vector<cv::Mat> unique;
    int width = kUsualWidth;
    for (const cv::Mat& texture : textures) {
        const auto [found, is_new] = known.try_emplace(texture.data, unique.size());
        if (is_new) {
            unique.push_back(asTexture(texture));
            width = std::max(width, unique.back().cols + 2 * kBorder);
        }
        owner_.push_back(found->second);
    }
    Shelves shelves(width);
    entries_.resize(unique.size());
    for (const Wanted& wanted : tallestFirst(unique)) {
        Levels& levels = entries_[wanted.entry];
        levels.resize(std::max(levels.size(), wanted.level + 1));
        levels[wanted.level] = shelves.place(wanted.size);
    }
    if (shelves.height() > kLargestHeight) {
        throw std::length_error("the textures of a scene need more than one atlas");
    }
    image_ = cv::Mat(shelves.height(), width, CV_8UC3, cv::Scalar(16, 16, 16));
    for (std::size_t entry = 0; entry < unique.size(); ++entry) {
        paint(image_, unique[entry], entries_[entry]);
    }
}

}  // namespace pmts::simulator
