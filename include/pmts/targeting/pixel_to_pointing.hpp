#pragma once

#include "pmts/camera/rig.hpp"
#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"
#include "pmts/geometry/ray.hpp"

#include <Eigen/Core>

#include <utility>

namespace pmts::targeting {

/// The rigorous model (PMTS reference, section 9): rays are rotated, never angles added.
class PixelToPointing {
public:
    explicit PixelToPointing(camera::Rig rig) : rig_(std::move(rig)) {}

    /// The half line this pixel sees, station frame. kUndefined when the lens model has no ray for it.
    [[nodiscard]] core::Result<geometry::Ray> rayForPixel(const Eigen::Vector2d& px,
                                                          const geometry::Pointing& at) const;
    /// Circle readings (face I) that put the telescope's axis on what this pixel shows, when it is
    /// `slope_distance_m` away from the optical centre. `at` are the readings when the frame was taken.
    /// kUndefined when the pixel has no ray or the ray never reaches that distance.
    [[nodiscard]] core::Result<geometry::Pointing> pointingForPixel(const Eigen::Vector2d& px,
                                                                    const geometry::Pointing& at,
                                                                    double slope_distance_m) const;
    /// Pixel at which the telescope's axis meets the view at this distance: the reticle. Parallax moves it
    /// with the distance. kUndefined behind the camera (a handle camera in face II) or without a distance.
    [[nodiscard]] core::Result<Eigen::Vector2d> reticlePixel(const geometry::Pointing& at,
                                                             double slope_distance_m) const;
    /// Pixel of a station-frame point in a frame taken at these readings.
    [[nodiscard]] core::Result<Eigen::Vector2d> pixelForPoint(const Eigen::Vector3d& p_station,
                                                              const geometry::Pointing& at) const;
    [[nodiscard]] const camera::Rig& rig() const { return rig_; }

private:
    camera::Rig rig_;
};

}  // namespace pmts::targeting
