#include "outward_lens.hpp"

#include <array>

namespace pmts::calibration {

camera::Lens continuedOutward(const camera::Lens& lens) {
    const auto* const brown = std::get_if<camera::BrownLens>(&lens.model());
    if (brown == nullptr) {
        return lens;
    }
    const std::array terms{1.0, brown->k1, brown->k2, brown->k3};  // of the powers of the radius squared
    std::size_t last = terms.size() - 1;
    while (last > 0 && terms.at(last) == 0) {
        --last;
    }
    if (last == 0 || terms.at(last) * terms.at(last - 1) >= 0) {
        return lens;
    }
    const double below = -terms.at(last) / terms.at(last - 1);
    std::array<double, 4> above{};
    for (std::size_t i = 1; i < last; ++i) {
        above.at(i) = terms.at(i) + below * terms.at(i - 1);
    }
    return camera::Lens(camera::RationalLens{.f_px = brown->f_px,
                                             .cx_px = brown->cx_px,
                                             .cy_px = brown->cy_px,
                                             .k1 = above[1],
                                             .k2 = above[2],
                                             .k3 = above[3],
                                             .k4 = below,
                                             .p1 = brown->p1,
                                             .p2 = brown->p2});
}

}  // namespace pmts::calibration
