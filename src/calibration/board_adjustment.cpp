#include "board_adjustment.hpp"

#include <ceres/autodiff_cost_function.h>
#include <ceres/covariance.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/rotation.h>
#include <ceres/solver.h>

#include <cmath>

namespace pmts::calibration {
namespace {

constexpr int kK3 = 5;  ///< place in the block

/// One corner: board to camera, Brown's lens as camera::BrownLens defines it, less what was seen.
struct CornerResidual {
    Eigen::Vector2d board_m;
    Eigen::Vector2d seen_px;

    template <class T>
    bool operator()(const T* lens, const T* pose, T* residual) const {
        const T on_board[3] = {T(board_m.x()), T(board_m.y()), T(0)};
        T p[3];
        ceres::AngleAxisRotatePoint(pose, on_board, p);
        p[0] += pose[3];
        p[1] += pose[4];
        p[2] += pose[5];
        if (!(p[2] > T(1e-9))) {
            return false;
        }
        const T x = p[0] / p[2];
        const T y = p[1] / p[2];
        const T r2 = x * x + y * y;
        const T radial = T(1) + r2 * (lens[3] + r2 * (lens[4] + r2 * lens[5]));
        const T& p1 = lens[6];
        const T& p2 = lens[7];
        residual[0] = lens[1] + lens[0] * (x * radial + T(2) * p1 * x * y + p2 * (r2 + T(2) * x * x)) - T(seen_px.x());
        residual[1] = lens[2] + lens[0] * (y * radial + p1 * (r2 + T(2) * y * y) + T(2) * p2 * x * y) - T(seen_px.y());
        return true;
    }
};

void addCorners(ceres::Problem& problem, const std::vector<BoardView>& views, BoardAdjustment& solution) {
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t i = 0; i < views[v].px.size(); ++i) {
            using Cost = ceres::AutoDiffCostFunction<CornerResidual, 2, kBoardIntrinsics, 6>;
            problem.AddResidualBlock(new Cost(new CornerResidual{views[v].board_m[i], views[v].px[i]}), nullptr,
                                     solution.intrinsics.data(), solution.poses[v].data());
        }
    }
}

/// The residuals at the solution, and their rms over coordinates.
void takeResiduals(const std::vector<BoardView>& views, BoardAdjustment& solution) {
    double sum_px2 = 0.0;
    double coordinates = 0.0;
    for (std::size_t v = 0; v < views.size(); ++v) {
        std::vector<Eigen::Vector2d>& residuals = solution.residuals_px.emplace_back();
        for (std::size_t i = 0; i < views[v].px.size(); ++i) {
            Eigen::Vector2d residual = Eigen::Vector2d::Zero();
            CornerResidual{views[v].board_m[i], views[v].px[i]}(solution.intrinsics.data(), solution.poses[v].data(), residual.data());
            residuals.push_back(residual);
            sum_px2 += residual.squaredNorm();
            coordinates += 2;
        }
    }
    solution.rms_px = std::sqrt(sum_px2 / coordinates);
}

/// Standard deviations of the lens, scaled by the residuals. None where the views leave a combination open.
void takeDeviations(ceres::Problem& problem, const std::vector<BoardView>& views, bool free_k3, BoardAdjustment& solution) {
    double coordinates = 0.0;
    for (const BoardView& view : views) {
        coordinates += 2.0 * static_cast<double>(view.px.size());
    }
    const double unknowns = kBoardIntrinsics - (free_k3 ? 0 : 1) + 6.0 * static_cast<double>(views.size());
    const double sigma0_px = solution.rms_px * std::sqrt(coordinates / std::max(1.0, coordinates - unknowns));
    ceres::Covariance::Options options;
    options.algorithm_type = ceres::SPARSE_QR;
    ceres::Covariance covariance(options);
    const double* const block = solution.intrinsics.data();
    const std::vector<std::pair<const double*, const double*>> wanted{{block, block}};
    if (!covariance.Compute(wanted, &problem)) {
        return;
    }
    std::array<double, kBoardIntrinsics * kBoardIntrinsics> values{};
    covariance.GetCovarianceBlock(block, block, values.data());
    for (std::size_t i = 0; i < kBoardIntrinsics; ++i) {
        if (free_k3 || i != kK3) {
            solution.deviations[i] = sigma0_px * std::sqrt(std::max(0.0, values[i * kBoardIntrinsics + i]));
        }
    }
}

}  // namespace

std::optional<BoardAdjustment> adjustBoards(const std::vector<BoardView>& views, const BoardIntrinsics& start,
                                            const std::vector<BoardPose>& poses, bool free_k3) {
    BoardAdjustment solution{.intrinsics = start, .deviations = {}, .poses = poses, .residuals_px = {}, .rms_px = 0.0};
    ceres::Problem problem;
    addCorners(problem, views, solution);
    if (!free_k3) {
        problem.SetManifold(solution.intrinsics.data(), new ceres::SubsetManifold(kBoardIntrinsics, {kK3}));
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.max_num_iterations = 200;
    options.function_tolerance = 1e-12;
    options.parameter_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable()) {
        return std::nullopt;
    }
    takeResiduals(views, solution);
    takeDeviations(problem, views, free_k3, solution);
    return solution;
}

}  // namespace pmts::calibration
