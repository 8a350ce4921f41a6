#pragma once

#include "pmts/targeting/method_report.hpp"

#include <functional>
#include <vector>

namespace pmts::app {

/// Called between the fits with how many are done of all; false ends them with kCancelled. Any thread.
using FitProgress = std::function<bool(int done, int all)>;

/// The rig with its eight unknowns fitted to the very targets of the report, and once without each of them.
/// Fails as calibration::fitRig() does.
[[nodiscard]] core::Result<targeting::FittedRig> fitToTargets(const std::vector<targeting::ListedTarget>& targets,
                                                              const targeting::MethodReportOptions& options,
                                                              const FitProgress& go_on = {});

}  // namespace pmts::app
