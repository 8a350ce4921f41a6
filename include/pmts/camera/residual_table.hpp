#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pmts::camera {

/// What a lens model leaves over, as a regular grid over the picture: seen pixel less modelled pixel, at the
/// seen pixel ("what you see is what you get"). Between the nodes bicubic (Catmull-Rom, one slope on both
/// sides); outside the grid the value of its nearest edge.
struct ResidualTable {
    double left_px = 0.0;  ///< column of the first node
    double top_px = 0.0;   ///< row of the first node
    double step_x_px = 100.0;
    double step_y_px = 100.0;
    int columns = 0;                        ///< nodes, at least 2
    int rows = 0;                           ///< nodes, at least 2
    std::vector<Eigen::Vector2d> nodes_px;  ///< row by row from the top left

    [[nodiscard]] bool operator==(const ResidualTable&) const = default;

    /// Seen less modelled pixel where the picture shows `seen_px`.
    [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& seen_px) const;
    /// The pixel that shows what the model puts at `modelled_px`: inverse of seen - at(seen), within 1e-10
    /// px.
    [[nodiscard]] std::optional<Eigen::Vector2d> seenFrom(const Eigen::Vector2d& modelled_px) const;
    /// Throws std::logic_error unless the grid is complete, finite, and so flat (less than 0.3 px for each
    /// px) that no two pixels show the same.
    void requireUnfolded() const;
};

/// Share of each node in the table's value at a pixel: (node index, weight), at most 16 of them.
/// The value is linear in the nodes, so that a fit of the nodes is linear too.
[[nodiscard]] std::vector<std::pair<int, double>> nodeShares(const ResidualTable& grid,
                                                             const Eigen::Vector2d& seen_px);

}  // namespace pmts::camera
