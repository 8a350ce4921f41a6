#include "pmts/camera/residual_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace pmts::camera {
namespace {

/// Weights of the nodes along one axis: four neighbours, those outside replaced by a straight line through
/// the last two.
struct AxisShares {
    std::array<int, 4> node{};
    std::array<double, 4> weight{};
};

AxisShares sharesAlong(double position, int nodes) {
    const double inside = std::clamp(position, 0.0, static_cast<double>(nodes - 1));
    const int cell = std::min(static_cast<int>(inside), nodes - 2);
    const double t = inside - cell;
    const double t2 = t * t;
    const double t3 = t2 * t;
    std::array<double, 4> weight{0.5 * (-t + 2 * t2 - t3), 0.5 * (2 - 5 * t2 + 3 * t3),
                                 0.5 * (t + 4 * t2 - 3 * t3), 0.5 * (t3 - t2)};
    if (cell == 0) {  // node -1 = 2 * node 0 - node 1
        weight[1] += 2 * weight[0];
        weight[2] -= weight[0];
        weight[0] = 0;
    }
    if (cell == nodes - 2) {  // node n = 2 * node n-1 - node n-2
        weight[2] += 2 * weight[3];
        weight[1] -= weight[3];
        weight[3] = 0;
    }
    AxisShares shares{.node = {}, .weight = weight};
    for (int i = 0; i < 4; ++i) {
        shares.node[static_cast<std::size_t>(i)] = std::clamp(cell - 1 + i, 0, nodes - 1);
    }
    return shares;
}

template <class Use>
void eachShare(const ResidualTable& grid, const Eigen::Vector2d& seen_px, Use use) {
    const AxisShares across = sharesAlong((seen_px.x() - grid.left_px) / grid.step_x_px, grid.columns);
    const AxisShares down = sharesAlong((seen_px.y() - grid.top_px) / grid.step_y_px, grid.rows);
    for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t i = 0; i < 4; ++i) {
            use(down.node[j] * grid.columns + across.node[i], down.weight[j] * across.weight[i]);
        }
    }
}

}  // namespace

Eigen::Vector2d ResidualTable::at(const Eigen::Vector2d& seen_px) const {
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    eachShare(*this, seen_px,
              [&](int node, double weight) { value += weight * nodes_px[static_cast<std::size_t>(node)]; });
    return value;
}

std::optional<Eigen::Vector2d> ResidualTable::seenFrom(const Eigen::Vector2d& modelled_px) const {
    Eigen::Vector2d seen_px = modelled_px;
    for (int i = 0; i < 100; ++i) {  // requireUnfolded() makes each step at least three times smaller
        const Eigen::Vector2d next_px = modelled_px + at(seen_px);
        const bool settled = (next_px - seen_px).norm() < 1e-11 * std::max(1.0, modelled_px.norm());
        seen_px = next_px;
        if (settled) {
            return seen_px;
        }
    }
    return std::nullopt;
}

void ResidualTable::requireUnfolded() const {
    constexpr double kSteepest = 0.3;
    bool good = columns >= 2 && rows >= 2 && step_x_px > 0 && step_y_px > 0 &&
                std::isfinite(left_px + top_px) &&
                nodes_px.size() == static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    const auto node = [this](int column, int row) {
        return nodes_px[static_cast<std::size_t>(row * columns + column)];
    };
    for (int row = 0; good && row < rows; ++row) {
        for (int column = 0; good && column < columns; ++column) {
            const Eigen::Vector2d here = node(column, row);
            good = here.allFinite() &&
                   (column == 0 || (here - node(column - 1, row)).norm() <= kSteepest * step_x_px) &&
                   (row == 0 || (here - node(column, row - 1)).norm() <= kSteepest * step_y_px);
        }
    }
    if (!good) {
        throw std::logic_error("a table of residuals is a complete grid and much flatter than the picture");
    }
}

std::vector<std::pair<int, double>> nodeShares(const ResidualTable& grid, const Eigen::Vector2d& seen_px) {
    std::vector<std::pair<int, double>> shares;
    eachShare(grid, seen_px, [&](int node, double weight) {
        if (weight != 0.0) {
            shares.emplace_back(node, weight);
        }
    });
    return shares;
}

}  // namespace pmts::camera
