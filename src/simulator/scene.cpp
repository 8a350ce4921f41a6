#include "pmts/simulator/scene.hpp"

#include "scene_atlas.hpp"
#include "scene_sky.hpp"

#include <Eigen/LU>

#include <cmath>

namespace pmts::simulator {
namespace {

Eigen::Vector3d direction(const geometry::Pointing& pointing) {
    const double horizontal = core::sin(pointing.va);
    return {horizontal * core::sin(pointing.ha), horizontal * core::cos(pointing.ha), core::cos(pointing.va)};
}

/// Distance along a unit direction from the optical centre to the panel; nullopt beside or behind it.
std::optional<double> distanceTo(const Panel& panel, const Eigen::Vector3d& along) {
    Eigen::Matrix3d axes;
    axes << panel.right_m, panel.up_m, -along;
    const double determinant = axes.determinant();
    if (std::abs(determinant) < 1e-9 * panel.right_m.norm() * panel.up_m.norm()) {
        return std::nullopt;  // seen edge-on
    }
    const Eigen::Vector3d hit = axes.inverse() * -panel.origin_m;  // fractions right and up, then metres
    const bool inside = hit.x() >= 0.0 && hit.x() <= 1.0 && hit.y() >= 0.0 && hit.y() <= 1.0;
    return inside && hit.z() > 0.0 ? std::optional(hit.z()) : std::nullopt;
}

}  // namespace

Scene::Scene(std::vector<Panel> panels, std::vector<Mark> marks, unsigned sky_seed)
    : panels_(std::move(panels)), marks_(std::move(marks)), sky_(cloudySky(sky_seed)) {
    std::vector<cv::Mat> textures;
    for (const std::vector<Panel>* group : {&panels_, &sky_}) {
        for (const Panel& panel : *group) {
            textures.push_back(panel.texture);
        }
    }
    atlas_ = std::make_shared<const TextureAtlas>(textures);
    std::size_t index = 0;
    for (std::vector<Panel>* group : {&panels_, &sky_}) {
        for (Panel& panel : *group) {
            panel.texture = atlas_->view(index++);  // the atlas holds the only copy
        }
    }
}

std::optional<Echo> Scene::echo(const geometry::Pointing& line_of_sight) const {
    const Eigen::Vector3d along = direction(line_of_sight);
    const Panel* nearest = nullptr;
    double nearest_m = 0.0;
    for (const Panel& panel : panels_) {
        const auto distance_m = distanceTo(panel, along);
        if (distance_m && (nearest == nullptr || *distance_m < nearest_m)) {
            nearest = &panel;
            nearest_m = *distance_m;
        }
    }
    if (nearest == nullptr || nearest->absorbing) {
        return std::nullopt;
    }
    return Echo{nearest_m, nearest->name};
}

}  // namespace pmts::simulator
