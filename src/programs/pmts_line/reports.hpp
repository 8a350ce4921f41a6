#pragma once

#include "command_line.hpp"

#include "pmts/app/line/line_findings.hpp"

namespace pmts::line {

/// Reads the file and does what was asked for; `progress` may be empty. The text is for the terminal. kUndefined when the
/// lines say nothing that has a framing.
[[nodiscard]] core::Result<QString> reportOf(const Request& request, const protocol::Progress& progress = {});

}  // namespace pmts::line
