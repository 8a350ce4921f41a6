#include "pmts/calibration/rig_fit.hpp"

#include "pixel_residuals.hpp"
#include "rig_parameters.hpp"

#include <Eigen/SVD>
#include <QCoreApplication>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pmts::calibration {
namespace {

using core::ErrorKind;
using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

QString text(const char* sentence) { return QCoreApplication::translate("RigFit", sentence); }

core::Result<void> usable(const std::vector<Sighting>& sightings, const camera::Rig& initial,
                          std::size_t unknowns) {
    if (!std::holds_alternative<camera::BrownLens>(initial.lens.model())) {
        return core::fail(ErrorKind::kBadInput, text("A lens given as a table cannot be fitted."),
                          text("Start from a lens with a focal length."));
    }
    if (2 * sightings.size() <= unknowns) {
        return core::fail(ErrorKind::kBadInput, text("There are too few targets for this calibration."),
                          text("Sight at least %1 targets.").arg(unknowns / 2 + 1));
    }
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        if (const auto px = pixelResidual(initial, sightings[i]); !px) {
            return core::fail(ErrorKind::kBadInput, text("Target %1 cannot be in its photo.").arg(i + 1),
                              text("Check its readings and those of the photo."), px.error().happened);
        }
    }
    return {};
}

struct Solution {
    std::vector<double> values;
    Eigen::VectorXd residuals_px;
    Jacobian jacobian;
};

core::Result<Solution> solve(const std::vector<Sighting>& sightings, const camera::Rig& initial,
                             const std::vector<RigParameter>& free) {
    Solution solution;
    for (const RigParameter parameter : free) {
        solution.values.push_back(parameterOf(initial, parameter));
    }
    const int rows = static_cast<int>(2 * sightings.size());
    const int columns = static_cast<int>(free.size());
    auto cost = std::make_unique<PixelResiduals>(sightings, initial, free);
    const PixelResiduals& residuals = *cost;
    ceres::Problem problem;
    problem.AddResidualBlock(cost.release(), nullptr, solution.values.data());

    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = 200;
    options.function_tolerance = 1e-14;
    options.parameter_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);

    solution.residuals_px.resize(rows);
    solution.jacobian.resize(rows, columns);
    const double* const at[] = {solution.values.data()};
    double* jacobians[] = {solution.jacobian.data()};
    if (!summary.IsSolutionUsable() || !residuals.Evaluate(at, solution.residuals_px.data(), jacobians)) {
        return core::fail(ErrorKind::kUndefined, text("The calibration does not settle."),
                          text("Check the sightings for a wrong target."),
                          QString::fromStdString(summary.message));
    }
    return solution;
}

/// Standard deviation of each unknown, absent where a direction the sightings cannot see moves it.
std::vector<std::optional<double>> standardDeviations(const Solution& solution) {
    constexpr double kUnseen =
        1e-6;  // of the largest singular value; numeric derivatives are good to about 1e-8
    constexpr double kMoves = 0.01;
    const Eigen::Index redundancy = solution.jacobian.rows() - solution.jacobian.cols();
    const double sigma0_px = std::sqrt(solution.residuals_px.squaredNorm() / static_cast<double>(redundancy));
    const Eigen::VectorXd scale = solution.jacobian.colwise().norm().transpose().cwiseMax(1e-300);
    const Eigen::MatrixXd scaled = solution.jacobian * scale.cwiseInverse().asDiagonal();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinV);
    const Eigen::VectorXd& seen = svd.singularValues();

    std::vector<std::optional<double>> deviations;
    for (Eigen::Index i = 0; i < scale.size(); ++i) {
        double variance = 0.0;
        bool determinable = true;
        for (Eigen::Index k = 0; k < seen.size(); ++k) {
            const double part = svd.matrixV()(i, k);
            if (seen(k) > kUnseen * seen(0)) {
                variance += part * part / (seen(k) * seen(k));
            } else if (std::abs(part) > kMoves) {
                determinable = false;
            }
        }
        deviations.push_back(determinable ? std::optional(sigma0_px * std::sqrt(variance) / scale(i))
                                          : std::nullopt);
    }
    return deviations;
}

RigFit report(const Solution& solution, const camera::Rig& initial, const std::vector<RigParameter>& free) {
    const Eigen::Index coordinates = solution.residuals_px.size();
    RigFit fit{.rig = rigWith(initial, free, solution.values.data()).value(),
               .rms_px = std::sqrt(solution.residuals_px.squaredNorm() / static_cast<double>(coordinates)),
               .largest_px = solution.residuals_px.lpNorm<Eigen::Infinity>(),
               .redundancy = static_cast<int>(coordinates - static_cast<Eigen::Index>(free.size())),
               .residuals_px = {},
               .parameters = {}};
    for (Eigen::Index i = 0; i < coordinates; i += 2) {
        fit.residuals_px.emplace_back(solution.residuals_px.segment<2>(i));
    }
    const auto deviations = standardDeviations(solution);
    for (std::size_t i = 0; i < free.size(); ++i) {
        fit.parameters.push_back({free[i], solution.values[i], deviations[i]});
    }
    return fit;
}

}  // namespace

core::Result<RigFit> fitRig(const std::vector<Sighting>& sightings, const camera::Rig& initial,
                            const std::vector<RigParameter>& free) {
    PMTS_TRY(usable(sightings, initial, free.size()));
    if (free.empty()) {
        throw std::logic_error("a fit has something to fit");
    }
    return solve(sightings, initial, free).map([&](const Solution& solution) {
        return report(solution, initial, free);
    });
}

core::Result<std::vector<camera::Rig>> fitWithoutEach(const std::vector<Sighting>& sightings,
                                                      const camera::Rig& initial,
                                                      const std::vector<RigParameter>& free,
                                                      const std::function<bool(std::size_t)>& go_on) {
    std::vector<camera::Rig> rigs;
    for (std::size_t left_out = 0; left_out < sightings.size(); ++left_out) {
        if (go_on && !go_on(left_out)) {
            return core::cancelled();
        }
        std::vector<Sighting> others = sightings;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
        auto fit = fitRig(others, initial, free);
        PMTS_TRY(fit);
        rigs.push_back(std::move(fit->rig));
    }
    return rigs;
}

core::Result<MountComparison> compareMounts(const std::vector<Sighting>& sightings,
                                            const camera::Rig& initial,
                                            const std::vector<RigParameter>& free) {
    const auto fitted = [&](camera::MountKind kind) {
        camera::Rig rig = initial;
        rig.mount.kind = kind;
        return fitRig(sightings, rig, free);
    };
    auto handle = fitted(camera::MountKind::kHandle);
    PMTS_TRY(handle);
    auto telescope = fitted(camera::MountKind::kTelescope);
    PMTS_TRY(telescope);
    const double ratio = std::pow(handle->rms_px / telescope->rms_px, 2);
    return MountComparison{.handle = std::move(*handle),
                           .telescope = std::move(*telescope),
                           .likelier = ratio < 1 ? camera::MountKind::kHandle : camera::MountKind::kTelescope,
                           .variance_ratio = ratio < 1 ? 1 / ratio : ratio};
}

}  // namespace pmts::calibration
