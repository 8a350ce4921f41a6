#pragma once

#include "pmts/app/field/method_page.hpp"
#include "pmts/core/result.hpp"

namespace pmts::gui {

/// The report as a PDF, A4: a page with the summary, then a page for each method with its table and plots. kFile when it
/// cannot be written.
[[nodiscard]] core::Result<void> writeReportPdf(const app::MethodReportView& report, const QString& path);

}  // namespace pmts::gui
