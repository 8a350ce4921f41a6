#include "residual_table_fit.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace pmts::calibration {
namespace {

camera::ResidualTable emptyGrid(int columns, int rows, double width_px, double height_px) {
    return {.left_px = 0,
            .top_px = 0,
            .step_x_px = width_px / (columns - 1),
            .step_y_px = height_px / (rows - 1),
            .columns = columns,
            .rows = rows,
            .nodes_px = std::vector<Eigen::Vector2d>(static_cast<std::size_t>(columns * rows),
                                                     Eigen::Vector2d::Zero())};
}

/// About square cells.
camera::ResidualTable gridOver(int columns, int width_px, int height_px) {
    const int rows = static_cast<int>((columns - 1.0) * height_px / width_px + 0.5) + 1;
    return emptyGrid(columns, std::max(3, rows), width_px - 1.0, height_px - 1.0);
}

/// Adds the square of a sum of nodes to the normal matrix.
void addSquare(Eigen::MatrixXd& normal, const std::vector<std::pair<int, double>>& sum, double weight) {
    for (const auto& [a, share_a] : sum) {
        for (const auto& [b, share_b] : sum) {
            normal(a, b) += weight * share_a * share_b;
        }
    }
}

/// Bending along rows, columns and across: a flat or tilted table costs nothing.
void addBending(Eigen::MatrixXd& normal, const camera::ResidualTable& grid, double stiffness) {
    const auto node = [&](int column, int row) { return row * grid.columns + column; };
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            if (column > 0 && column + 1 < grid.columns) {
                addSquare(normal,
                          {{node(column - 1, row), 1}, {node(column, row), -2}, {node(column + 1, row), 1}},
                          stiffness);
            }
            if (row > 0 && row + 1 < grid.rows) {
                addSquare(normal,
                          {{node(column, row - 1), 1}, {node(column, row), -2}, {node(column, row + 1), 1}},
                          stiffness);
            }
            if (column + 1 < grid.columns && row + 1 < grid.rows) {
                addSquare(normal,
                          {{node(column, row), 1},
                           {node(column + 1, row), -1},
                           {node(column, row + 1), -1},
                           {node(column + 1, row + 1), 1}},
                          2 * stiffness);
            }
        }
    }
}

/// Steps from a node to the nearest picture.
double stepsToData(const camera::ResidualTable& grid, int column, int row,
                   const std::vector<LeftOver>& left_over) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const LeftOver& one : left_over) {
        const Eigen::Vector2d steps((one.seen_px.x() - grid.left_px) / grid.step_x_px - column,
                                    (one.seen_px.y() - grid.top_px) / grid.step_y_px - row);
        nearest = std::min(nearest, steps.norm());
    }
    return nearest;
}

camera::ResidualTable fittedPlane(const std::vector<LeftOver>& left_over, int width_px, int height_px,
                                  double stiffness) {
    camera::ResidualTable grid = gridOver(11, width_px, height_px);
    const int nodes = grid.columns * grid.rows;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(nodes, nodes);
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(nodes, 2);
    for (const LeftOver& one : left_over) {
        const auto shares = camera::nodeShares(grid, one.seen_px);
        addSquare(normal, shares, 1.0);
        for (const auto& [node, share] : shares) {
            wanted.row(node) += share * one.seen_less_modelled_px.transpose();
        }
    }
    addBending(normal, grid, stiffness);
    constexpr double kFarSteps = 1.5;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const int node = row * grid.columns + column;
            normal(node, node) += stepsToData(grid, column, row, left_over) > kFarSteps ? 1.0 : 1e-6;
        }
    }
    const Eigen::MatrixXd solved = normal.ldlt().solve(wanted);
    for (int node = 0; node < nodes; ++node) {
        grid.nodes_px[static_cast<std::size_t>(node)] = solved.row(node).transpose();
    }
    return grid;
}

/// A curve over the radius, kept in the upper row of a grid of two: zero at the centre, level past the last
/// picture.
camera::ResidualTable fittedRadial(const std::vector<LeftOver>& left_over, const Eigen::Vector2d& centre_px,
                                   double stiffness) {
    constexpr int kNodes = 15;
    double furthest_px = 1.0;
    for (const LeftOver& one : left_over) {
        furthest_px = std::max(furthest_px, (one.seen_px - centre_px).norm());
    }
    camera::ResidualTable curve = emptyGrid(kNodes, 2, furthest_px, 1.0);
    Eigen::MatrixXd normal = Eigen::MatrixXd::Identity(kNodes, kNodes) * 1e-6;
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(kNodes);
    normal(0, 0) += 1e6;
    for (const LeftOver& one : left_over) {
        const Eigen::Vector2d from_centre_px = one.seen_px - centre_px;
        const double radius_px = std::max(from_centre_px.norm(), 1e-9);
        const auto shares = camera::nodeShares(curve, {radius_px, 0});
        addSquare(normal, shares, 1.0);
        for (const auto& [node, share] : shares) {
            wanted(node) += share * one.seen_less_modelled_px.dot(from_centre_px) / radius_px;
        }
    }
    for (int node = 1; node + 1 < kNodes; ++node) {
        addSquare(normal, {{node - 1, 1}, {node, -2}, {node + 1, 1}}, stiffness);
    }
    const Eigen::VectorXd solved = normal.ldlt().solve(wanted);
    for (int node = 0; node < kNodes; ++node) {
        curve.nodes_px[static_cast<std::size_t>(node)].x() = solved(node);
    }
    return curve;
}

}  // namespace

ResidualSurface::ResidualSurface(const std::vector<LeftOver>& left_over, const Eigen::Vector2d& centre_px,
                                 int width_px, int height_px, const TableStiffness& stiffness)
    : centre_px_(centre_px) {
    std::vector<LeftOver> rest = left_over;
    if (stiffness.radial) {
        radial_ = fittedRadial(left_over, centre_px, *stiffness.radial);
        for (LeftOver& one : rest) {
            one.seen_less_modelled_px -= radialAt(one.seen_px);
        }
    }
    if (stiffness.plane) {
        plane_ = fittedPlane(rest, width_px, height_px, *stiffness.plane);
    }
}

Eigen::Vector2d ResidualSurface::radialAt(const Eigen::Vector2d& seen_px) const {
    const Eigen::Vector2d from_centre_px = seen_px - centre_px_;
    const double radius_px = from_centre_px.norm();
    return radius_px > 0 ? Eigen::Vector2d(radial_->at({radius_px, 0}).x() / radius_px * from_centre_px)
                         : Eigen::Vector2d::Zero();
}

Eigen::Vector2d ResidualSurface::at(const Eigen::Vector2d& seen_px) const {
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    if (radial_) {
        value += radialAt(seen_px);
    }
    if (plane_) {
        value += plane_->at(seen_px);
    }
    return value;
}

std::optional<camera::ResidualTable> ResidualSurface::table(int width_px, int height_px) const {
    constexpr int kColumns = 33;
    camera::ResidualTable table = gridOver(kColumns, width_px, height_px);
    for (int row = 0; row < table.rows; ++row) {
        for (int column = 0; column < table.columns; ++column) {
            table.nodes_px[static_cast<std::size_t>(row * table.columns + column)] =
                at({table.left_px + column * table.step_x_px, table.top_px + row * table.step_y_px});
        }
    }
    try {
        table.requireUnfolded();
    } catch (const std::logic_error&) {
        return std::nullopt;
    }
    return table;
}

}  // namespace pmts::calibration
