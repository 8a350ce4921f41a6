#pragma once

#include "pmts/camera/residual_table.hpp"

#include <optional>
#include <vector>

namespace pmts::calibration {

/// What a picture shows beside the model: where, and seen less modelled pixel.
struct LeftOver {
    Eigen::Vector2d seen_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d seen_less_modelled_px = Eigen::Vector2d::Zero();
};

/// How stiff the two parts of a table are; absent: without that part.
struct TableStiffness {
    std::optional<double> radial;  ///< about the principal point: what another lens model would do
    std::optional<double> plane;   ///< anything else
};

/// What is left over as a smooth function of the place: first of the radius alone, then of both coordinates.
class ResidualSurface {
public:
    ResidualSurface(const std::vector<LeftOver>& left_over, const Eigen::Vector2d& centre_px, int width_px,
                    int height_px, const TableStiffness& stiffness);

    [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& seen_px) const;
    /// The surface as a table; nothing when it would fold the picture.
    [[nodiscard]] std::optional<camera::ResidualTable> table(int width_px, int height_px) const;

private:
    [[nodiscard]] Eigen::Vector2d radialAt(const Eigen::Vector2d& seen_px) const;

    Eigen::Vector2d centre_px_;
    std::optional<camera::ResidualTable> radial_;  ///< outward px over the radius, in x of its upper row
    std::optional<camera::ResidualTable> plane_;
};

}  // namespace pmts::calibration
