#include "outward_lens.hpp"

#include <Eigen/QR>

namespace pmts::calibration {

camera::Lens continuedOutward(const camera::Lens& lens, double seen_radius) {
    const auto* const brown = std::get_if<camera::BrownLens>(&lens.model());
    if (brown == nullptr || brown->k3 != 0) {
        return lens;
    }
    double above = 0;
    double below = -brown->k1;
    if (brown->k2 != 0) {  // both as the polynomial has it where it was seen
        constexpr int kSamples = 20;
        Eigen::Matrix<double, kSamples, 2> slopes;
        Eigen::Matrix<double, kSamples, 1> bends;
        for (int i = 0; i < kSamples; ++i) {
            const double r2 = (i + 1.0) / kSamples * seen_radius * seen_radius;
            const double bend = brown->k1 * r2 + brown->k2 * r2 * r2;
            slopes.row(i) << r2, -(1 + bend) * r2;
            bends(i) = bend;
        }
        const Eigen::Vector2d found = slopes.colPivHouseholderQr().solve(bends);
        above = found.x();
        below = found.y();
    }
    if (!(below > 0) || below > 20) {
        return lens;
    }
    return camera::Lens(camera::RationalLens{.f_px = brown->f_px,
                                             .cx_px = brown->cx_px,
                                             .cy_px = brown->cy_px,
                                             .k1 = above,
                                             .k4 = below,
                                             .p1 = brown->p1,
                                             .p2 = brown->p2});
}

}  // namespace pmts::calibration
