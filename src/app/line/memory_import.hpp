#pragma once

#include "pmts/core/result.hpp"
#include "pmts/survey/planned_point.hpp"

#include <QString>

#include <vector>

namespace pmts::app {

/// By its ending: .job or .are.
[[nodiscard]] bool isMemoryFile(const QString& path);

/// The points of a job or area file that have N, E and elevation. kBadInput names a line that cannot be read, or says
/// that the units are not in the file: then it is opened on the page Memory, where they can be chosen.
[[nodiscard]] core::Result<std::vector<survey::PlannedPoint>> plannedFromMemoryFile(const QString& path);

}  // namespace pmts::app
