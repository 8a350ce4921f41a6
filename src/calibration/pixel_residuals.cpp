#include "pixel_residuals.hpp"

#include "rig_parameters.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::calibration {

core::Result<Eigen::Vector2d> pixelResidual(const camera::Rig& rig, const Sighting& sighting) {
    const auto px = camera::pixelFromStation(rig, sighting.at, geometry::stationFromPolar(sighting.target));
    return px.map(
        [&sighting](const Eigen::Vector2d& modelled) { return Eigen::Vector2d(modelled - sighting.px); });
}

PixelResiduals::PixelResiduals(const std::vector<Sighting>& sightings, const camera::Rig& initial,
                               const std::vector<RigParameter>& free)
    : sightings_(sightings), initial_(initial), free_(free) {
    mutable_parameter_block_sizes()->push_back(static_cast<int>(free.size()));
    set_num_residuals(static_cast<int>(2 * sightings.size()));
}

bool PixelResiduals::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::VectorXd values =
        Eigen::Map<const Eigen::VectorXd>(parameters[0], parameter_block_sizes()[0]);
    const auto here = residualsAt(values);
    if (!here) {
        return false;
    }
    Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = *here;
    if (jacobians == nullptr || jacobians[0] == nullptr) {
        return true;
    }
    Eigen::Map<RowMajor> jacobian(jacobians[0], num_residuals(), values.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const auto column = derivative(values, *here, i);
        if (!column) {
            return false;
        }
        jacobian.col(i) = *column;
    }
    return true;
}

std::optional<Eigen::VectorXd> PixelResiduals::residualsAt(const Eigen::VectorXd& values) const {
    const auto rig = rigWith(initial_, free_, values.data());
    if (!rig) {
        return std::nullopt;
    }
    Eigen::VectorXd residuals(num_residuals());
    for (std::size_t i = 0; i < sightings_.size(); ++i) {
        const auto px = pixelResidual(*rig, sightings_[i]);
        if (!px) {
            return std::nullopt;
        }
        residuals.segment<2>(static_cast<Eigen::Index>(2 * i)) = *px;
    }
    return residuals;
}

std::optional<Eigen::VectorXd> PixelResiduals::derivative(const Eigen::VectorXd& values,
                                                          const Eigen::VectorXd& here,
                                                          Eigen::Index parameter) const {
    constexpr double kRelativeStep = 1e-5;  // rounding and the neglected third order are both below 1e-8 here
    const double step = kRelativeStep * std::max(1.0, std::abs(values(parameter)));
    const auto moved = [&](double by) {
        Eigen::VectorXd shifted = values;
        shifted(parameter) += by;
        return residualsAt(shifted);
    };
    const auto above = moved(step);
    const auto below = moved(-step);
    if (above && below) {
        return Eigen::VectorXd((*above - *below) / (2 * step));
    }
    if (above) {
        return Eigen::VectorXd((*above - here) / step);
    }
    return below ? std::optional(Eigen::VectorXd((here - *below) / step)) : std::nullopt;
}

}  // namespace pmts::calibration
