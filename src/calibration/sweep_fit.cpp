#include "sweep_fit.hpp"

#include <QCoreApplication>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pmts::calibration {
namespace {

tl::unexpected<core::Error> unsettled(const QString& detail) {
    return core::fail(core::ErrorKind::kUndefined,
                      QCoreApplication::translate("Calibration", "The calibration does not settle."),
                      QCoreApplication::translate(
                          "Calibration", "Choose a sharp spot, check the mount kind, and sweep again."),
                      detail);
}

double lengthAt(const Eigen::VectorXd& residuals_px, std::size_t picture) {
    return residuals_px.segment<2>(static_cast<Eigen::Index>(2 * picture)).norm();
}

/// Spread of the lengths, from their median: half of the pictures may be wrong. 1.177 is the median length of
/// two coordinates of spread one.
double spread_px(const Eigen::VectorXd& residuals_px) {
    std::vector<double> lengths;
    for (Eigen::Index i = 0; i < residuals_px.size() / 2; ++i) {
        lengths.push_back(lengthAt(residuals_px, static_cast<std::size_t>(i)));
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle / 1.177;
}

}  // namespace

double rmsOf(const Eigen::VectorXd& residuals_px, const std::vector<bool>& pictures) {
    double sum2 = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        if (pictures[i]) {
            sum2 += std::pow(lengthAt(residuals_px, i), 2);
            count += 2;
        }
    }
    return count > 0 ? std::sqrt(sum2 / static_cast<double>(count)) : 0.0;
}

double SweepFit::rms_px() const {
    std::vector<bool> used;
    for (const double weight : weights) {
        used.push_back(weight > 0);
    }
    return rmsOf(residuals_px, used);
}

core::Result<SweepFit> fitSweep(const SweepState& start, const SweepUnknowns& unknowns,
                                const std::vector<double>& weights) {
    Eigen::VectorXd values = valuesOf(start, unknowns);
    auto owned = std::make_unique<SweepCost>(start, unknowns, weights);
    const SweepCost& cost = *owned;
    ceres::Problem problem;
    problem.AddResidualBlock(owned.release(), nullptr, values.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = 100;
    options.function_tolerance = 1e-10;
    options.parameter_tolerance = 1e-11;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable()) {
        return unsettled(QString::fromStdString(summary.message));
    }
    const auto state = stateWith(start, unknowns, values);
    const auto residuals = state ? sweepResiduals(*state, weights) : std::nullopt;
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> jacobian(2 * weights.size(),
                                                                                    unknowns.count());
    Eigen::VectorXd weighted(2 * weights.size());
    const double* const at[] = {values.data()};
    double* jacobians[] = {jacobian.data()};
    if (!residuals || !cost.Evaluate(at, weighted.data(), jacobians)) {
        return unsettled({});
    }
    const auto used = std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > 0; });
    const double redundancy =
        std::max(1.0, 2.0 * static_cast<double>(used) - static_cast<double>(values.size()));
    return SweepFit{.state = *state,
                    .unknowns = unknowns,
                    .residuals_px = *residuals,
                    .jacobian = jacobian,
                    .weights = weights,
                    .sigma0_px = std::sqrt(weighted.squaredNorm() / redundancy)};
}

core::Result<SweepFit> fitSweepRobustly(const SweepState& start, const SweepUnknowns& unknowns) {
    std::size_t pictures = 0;
    for (const SweptSpot& spot : start.spots) {
        pictures += spot.pictures.size();
    }
    constexpr double kLeast_px = 0.02;  // below the matcher's own noise nothing is an outlier
    auto fit = fitSweep(start, unknowns, std::vector<double>(pictures, 1.0));
    for (int round = 0; fit && round < 6; ++round) {
        const double spread = std::max(kLeast_px, spread_px(fit->residuals_px));
        std::vector<double> weights;
        for (std::size_t i = 0; i < pictures; ++i) {
            const double in_spreads = lengthAt(fit->residuals_px, i) / (3 * spread);
            weights.push_back(1.0 / (1.0 + in_spreads * in_spreads));
        }
        fit = fitSweep(fit->state, unknowns, weights);
    }
    for (int round = 0; fit && round < 3; ++round) {
        const double spread = std::max(kLeast_px, spread_px(fit->residuals_px));
        std::vector<double> weights;
        for (std::size_t i = 0; i < pictures; ++i) {
            weights.push_back(lengthAt(fit->residuals_px, i) > 5 * spread ? 0.0 : 1.0);
        }
        const bool same = weights == fit->weights;
        fit = fitSweep(fit->state, unknowns, weights);
        if (same) {
            break;
        }
    }
    return fit;
}

}  // namespace pmts::calibration
