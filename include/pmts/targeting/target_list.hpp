#pragma once

#include "pmts/core/result.hpp"
#include "pmts/geometry/polar.hpp"

#include <Eigen/Core>
#include <QString>

#include <optional>
#include <vector>

namespace pmts::targeting {

/// A target of a method report: sighted with the telescope, clicked in one photo.
struct ListedTarget {
    QString name;
    geometry::PolarPoint observed;
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    /// What somebody printed for it before, as the thesis's tables 6.1-6.3; absent where a column is missing.
    std::optional<geometry::Pointing> printed_apa, printed_tpa, printed_oatpa;
};

/// Reads a table of targets: comma, semicolon or tab; lines that start with # are comments; the first other
/// line names the columns, in any order. Needed: no (or name), sd, sha, sva, u, v (metres, gon, pixels).
/// Known: apa_sha, apa_sva, tpa_sha, tpa_sva, oatpa_sha, oatpa_sva; every other column is passed over.
/// kBadInput with the number of the line and the name of the column.
[[nodiscard]] core::Result<std::vector<ListedTarget>> readTargetList(const QString& text);

/// The table that readTargetList() reads, with a comment above it (may be empty, may have several lines). The
/// printed columns are written when a target has them. Angles to 0.1 cc, pixels to 0.01, metres to 0.1 mm.
[[nodiscard]] QString targetListText(const std::vector<ListedTarget>& targets, const QString& comment);

/// readTargetList() of a file; kFile when it cannot be read.
[[nodiscard]] core::Result<std::vector<ListedTarget>> readTargetFile(const QString& path);

}  // namespace pmts::targeting
