#pragma once

#include "pmts/targeting/method_report.hpp"

namespace pmts::targeting {

/// The report's pages as plain text, fixed pitch.
[[nodiscard]] QString textOfTables(const std::vector<ListedTarget>& targets,
                                   const MethodReportOptions& options,
                                   const std::vector<MethodTable>& tables);

}  // namespace pmts::targeting
