#include "pmts/camera/scaled_rig.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace pmts::camera {
namespace {

/// Scale and cut from one picture size to another.
struct Fit {
    double scale = 1.0;
    double cut_x_px = 0.0;  ///< at each side, in the new picture's pixels
    double cut_y_px = 0.0;

    Fit(int from_width, int from_height, int to_width, int to_height)
        : scale(std::max(static_cast<double>(to_width) / from_width, static_cast<double>(to_height) / from_height)),
          cut_x_px((scale * from_width - to_width) / 2.0),
          cut_y_px((scale * from_height - to_height) / 2.0) {}
    [[nodiscard]] double x(double u) const { return scale * (u + 0.5) - cut_x_px - 0.5; }
    [[nodiscard]] double y(double v) const { return scale * (v + 0.5) - cut_y_px - 0.5; }
};

/// Every model with one focal length; its distortion has no unit.
template <class FocalLens>
Lens scaledLens(FocalLens lens, const Fit& fit) {
    lens.f_px *= fit.scale;
    lens.cx_px = fit.x(lens.cx_px);
    lens.cy_px = fit.y(lens.cy_px);
    return Lens(lens);
}

Lens scaledLens(RadialTableLens lens, const Fit& fit) {
    lens.cx_px = fit.x(lens.cx_px);
    lens.cy_px = fit.y(lens.cy_px);
    for (RadialTableLens::Row& row : lens.rows) {
        row.radius_px *= fit.scale;
    }
    return Lens(std::move(lens));
}

std::optional<ResidualTable> scaledTable(std::optional<ResidualTable> table, const Fit& fit) {
    if (table) {
        table->left_px = fit.x(table->left_px);
        table->top_px = fit.y(table->top_px);
        table->step_x_px *= fit.scale;
        table->step_y_px *= fit.scale;
        for (Eigen::Vector2d& node_px : table->nodes_px) {
            node_px *= fit.scale;
        }
    }
    return table;
}

}  // namespace

Rig scaledRig(const Rig& rig, int width_px, int height_px) {
    if (rig.width_px == width_px && rig.height_px == height_px) {
        return rig;
    }
    const Fit fit(rig.width_px, rig.height_px, width_px, height_px);
    Rig scaled = rig;
    scaled.lens = std::visit([&fit](const auto& lens) { return scaledLens(lens, fit); }, rig.lens.model())
                      .withResiduals(scaledTable(rig.lens.residuals(), fit));
    scaled.width_px = width_px;
    scaled.height_px = height_px;
    return scaled;
}

}  // namespace pmts::camera
