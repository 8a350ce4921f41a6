#pragma once

#include "pmts/camera/rig.hpp"
#include "scene_atlas.hpp"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <vector>

namespace pmts::simulator {

/// Direction (x/z, y/z) in the camera frame that each pixel sees, CV_32F; NaN where the lens model has no
/// inverse.
struct RayTable {
    cv::Mat x;
    cv::Mat y;
    /// From the lens at every 8th pixel, linear between: within 0.01 px for any usable lens, and 60 times
    /// faster.
    [[nodiscard]] static RayTable of(const camera::Rig& rig);
};

/// A rectangle as the camera sees it. For a ray r = (x, y, 1): (a, b, c) = patch_from_ray * r; a/c runs along
/// the upper edge, b/c down the left one, both 0 to 1 inside, and c is the inverse depth: negative behind the
/// camera.
struct ScenePatch {
    Eigen::Matrix3f patch_from_ray;
    std::size_t texture = 0;
    cv::Rect bounds;  ///< pixels it may cover
};

/// Finds the nearest patch of each pixel and reads its texture, straight through the lens: one resampling.
class SceneRasteriser {
public:
    SceneRasteriser(const TextureAtlas& atlas, RayTable rays);

    /// Draws into an 8-bit BGR image of the ray table's size.
    void draw(const std::vector<ScenePatch>& patches, cv::Mat& image);

private:
    void findNearest(const std::vector<ScenePatch>& patches, int first_row, int last_row);
    void fillMaps(const std::vector<ScenePatch>& patches, int first_row, int last_row);
    void mapRun(const ScenePatch& patch, int row, int band_row, int begin, int end);

    const TextureAtlas& atlas_;
    RayTable rays_;
    float rays_per_pixel_;
    cv::Mat nearest_;  ///< of one band of rows: inverse depth, CV_32F
    cv::Mat owner_;    ///< index of the patch seen, CV_32S
    cv::Mat map_xy_;
    cv::Mat map_fraction_;
};

}  // namespace pmts::simulator
