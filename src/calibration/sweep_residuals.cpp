#include "sweep_residuals.hpp"

#include "rig_parameters.hpp"

#include <algorithm>
#include <cmath>

namespace pmts::calibration {

Eigen::VectorXd valuesOf(const SweepState& state, const SweepUnknowns& unknowns) {
    Eigen::VectorXd values(unknowns.count());
    Eigen::Index i = 0;
    for (const RigParameter parameter : unknowns.rig) {
        values(i++) = parameterOf(state.rig, parameter);
    }
    for (const std::size_t spot : unknowns.directions) {
        values(i++) = state.spots[spot].about.pointing.ha.rad();
        values(i++) = state.spots[spot].about.pointing.va.rad();
    }
    return values;
}

std::optional<SweepState> stateWith(const SweepState& start, const SweepUnknowns& unknowns,
                                    const Eigen::VectorXd& values) {
    const auto rig = rigWith(start.rig, unknowns.rig, values.data());
    if (!rig || !values.allFinite()) {
        return std::nullopt;
    }
    SweepState state{*rig, start.spots};
    auto i = static_cast<Eigen::Index>(unknowns.rig.size());
    for (const std::size_t spot : unknowns.directions) {
        state.spots[spot].about.pointing.ha = core::Angle::fromRad(values(i++));
        state.spots[spot].about.pointing.va = core::Angle::fromRad(values(i++));
    }
    return state;
}

std::optional<Eigen::VectorXd> sweepResiduals(const SweepState& state, const std::vector<double>& weights) {
    Eigen::VectorXd residuals(static_cast<Eigen::Index>(2 * weights.size()));
    std::size_t i = 0;
    for (const SweptSpot& spot : state.spots) {
        const Eigen::Vector3d p_station = geometry::stationFromPolar(spot.about);
        for (const SpotPicture& picture : spot.pictures) {
            const auto px = camera::pixelFromStation(state.rig, picture.at, p_station);
            if (!px && weights[i] > 0) {
                return std::nullopt;
            }
            residuals.segment<2>(static_cast<Eigen::Index>(2 * i)) =
                px ? Eigen::Vector2d(*px - picture.px) : Eigen::Vector2d(1e3, 1e3);
            ++i;
        }
    }
    return residuals;
}

SweepCost::SweepCost(const SweepState& start, const SweepUnknowns& unknowns,
                     const std::vector<double>& weights)
    : start_(start), unknowns_(unknowns), weights_(weights) {
    mutable_parameter_block_sizes()->push_back(static_cast<int>(unknowns.count()));
    set_num_residuals(static_cast<int>(2 * weights.size()));
}

std::optional<Eigen::VectorXd> SweepCost::weighted(const Eigen::VectorXd& values) const {
    const auto state = stateWith(start_, unknowns_, values);
    auto residuals = state ? sweepResiduals(*state, weights_) : std::nullopt;
    if (residuals) {
        for (std::size_t i = 0; i < weights_.size(); ++i) {
            residuals->segment<2>(static_cast<Eigen::Index>(2 * i)) *= std::sqrt(weights_[i]);
        }
    }
    return residuals;
}

bool SweepCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
    const Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(parameters[0], unknowns_.count());
    const auto here = weighted(values);
    if (!here) {
        return false;
    }
    Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = *here;
    if (jacobians == nullptr || jacobians[0] == nullptr) {
        return true;
    }
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor> jacobian(jacobians[0], num_residuals(), values.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const double step = 1e-5 * std::max(1.0, std::abs(values(i)));
        const auto moved = [&](double by) {
            Eigen::VectorXd shifted = values;
            shifted(i) += by;
            return weighted(shifted);
        };
        const auto above = moved(step);
        const auto below = moved(-step);
        if (!above && !below) {
            return false;
        }
        jacobian.col(i) = above && below ? Eigen::VectorXd((*above - *below) / (2 * step))
                          : above        ? Eigen::VectorXd((*above - *here) / step)
                                         : Eigen::VectorXd((*here - *below) / step);
    }
    return true;
}

}  // namespace pmts::calibration
