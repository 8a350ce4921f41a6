#include "pmts/camera/scaled_rig.hpp"

#include <variant>

namespace pmts::camera {
namespace {

struct Resampling {
    double factor;
    double down_px;  ///< added to rows after the scaling

    [[nodiscard]] double across(double u) const { return (u + 0.5) * factor - 0.5; }
    [[nodiscard]] double down(double v) const { return (v + 0.5) * factor - 0.5 + down_px; }
};

BrownLens resampled(BrownLens lens, const Resampling& by) {
    lens.f_px *= by.factor;
    lens.cx_px = by.across(lens.cx_px);
    lens.cy_px = by.down(lens.cy_px);
    return lens;
}

RadialTableLens resampled(RadialTableLens lens, const Resampling& by) {
    lens.cx_px = by.across(lens.cx_px);
    lens.cy_px = by.down(lens.cy_px);
    for (RadialTableLens::Row& row : lens.rows) {
        row.radius_px *= by.factor;
    }
    return lens;
}

}  // namespace

Rig scaledRig(const Rig& rig, int width_px, int height_px) {
    const double factor = static_cast<double>(width_px) / rig.width_px;
    const Resampling by{.factor = factor, .down_px = (height_px - rig.height_px * factor) / 2};
    Rig scaled = rig;
    scaled.lens = std::visit([&by](const auto& model) { return Lens(resampled(model, by)); }, rig.lens.model());
    scaled.width_px = width_px;
    scaled.height_px = height_px;
    return scaled;
}

}  // namespace pmts::camera
