#pragma once

#include <opencv2/core/mat.hpp>

#include <vector>

namespace pmts::simulator {

/// All textures of a scene in one image, each with its halves, quarters, ... so that one remap draws a whole
/// frame. Each copy has a border of repeated edge pixels: bilinear reading never meets a neighbour. Pixel (0,
/// 0) is dark: nothing.
class TextureAtlas {
public:
    /// Where the sizes of one texture lie, full size first.
    using Levels = std::vector<cv::Rect>;

    /// Textures that share their pixels are stored once.
    explicit TextureAtlas(const std::vector<cv::Mat>& textures);

    [[nodiscard]] const cv::Mat& image() const { return image_; }
    [[nodiscard]] const Levels& levels(std::size_t texture) const { return entries_[owner_[texture]]; }
    /// The full size of a texture, as a view into the atlas.
    [[nodiscard]] cv::Mat view(std::size_t texture) const { return image_(levels(texture).front()); }

private:
    cv::Mat image_;
    std::vector<std::size_t> owner_;  ///< entry of each texture
    std::vector<Levels> entries_;
};

}  // namespace pmts::simulator
