#pragma once

#include <Eigen/Core>

#include <complex>

namespace pmts::targeting {

/// How the picture moves compared with the rig model: one scale and one turn, learned from the longest move
/// so far. A focal length 2 % wrong shows as the scale, a wrong twist as the turn.
class LocalMotion {
public:
    /// After a move: how far the spot should have moved, and how far it did.
    void learn(const Eigen::Vector2d& modelled_px, const Eigen::Vector2d& seen_px) {
        constexpr double kLeastMove_px = 10.0;  // shorter ones say less than they cost
        constexpr double kMostOff = 0.15;       // more is not a slightly wrong rig
        const std::complex<double> modelled(modelled_px.x(), modelled_px.y());
        const std::complex<double> seen(seen_px.x(), seen_px.y());
        if (std::abs(modelled) < kLeastMove_px || std::abs(modelled) < longest_px_ ||
            std::abs(seen / modelled - 1.0) > kMostOff) {
            return;
        }
        longest_px_ = std::abs(modelled);
        seen_from_modelled_ = seen / modelled;
    }
    /// The way in the model's picture that becomes `seen_px` in the camera's.
    [[nodiscard]] Eigen::Vector2d asModelled(const Eigen::Vector2d& seen_px) const {
        const std::complex<double> modelled =
            std::complex<double>(seen_px.x(), seen_px.y()) / seen_from_modelled_;
        return {modelled.real(), modelled.imag()};
    }

private:
    std::complex<double> seen_from_modelled_{1.0, 0.0};
    double longest_px_ = 0.0;
};

}  // namespace pmts::targeting
