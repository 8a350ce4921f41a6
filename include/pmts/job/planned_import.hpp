#pragma once

#include "pmts/core/result.hpp"
#include "pmts/survey/planned_point.hpp"

#include <QByteArray>
#include <QString>

#include <vector>

namespace pmts::job {

/// Planned points from a table of text: ID, E, N, H, code, remark in metres, in this order, or in the order a
/// first line of names gives (PMTS's own CSV export has one). Commas, semicolons or tabs; a decimal comma
/// where the comma does not part columns; UTF-8 or Latin-1; empty lines and lines that start with # are left
/// out. kBadInput names the line that cannot be read: then nothing of the file is used.
[[nodiscard]] core::Result<std::vector<survey::PlannedPoint>> plannedFromText(const QByteArray& bytes);

/// The same from a file; kFile when it cannot be read, kLimit when it is larger than 64 MB.
[[nodiscard]] core::Result<std::vector<survey::PlannedPoint>> plannedFromFile(const QString& path);

}  // namespace pmts::job
