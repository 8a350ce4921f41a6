#pragma once

#include "pmts/app/field/method_report_presenter.hpp"

namespace pmts::app {

/// The options as the form shows them.
[[nodiscard]] MethodReportForm reportFormOf(const targeting::MethodReportOptions& options, RigOfReport rig,
                                            const UnitFormat& units);

/// Puts what the text says into the options. kBadInput with a sentence, the options are as before then.
[[nodiscard]] core::Result<void> readReportField(ReportField field, const QString& text, const UnitFormat& units,
                                                 targeting::MethodReportOptions& options);

/// The options as `pmts --method-report` takes them: `--image 640x480 --centre 315,240 ...`.
[[nodiscard]] QString argumentsOf(const targeting::MethodReportOptions& options);

/// Takes over every option that stands in a text as argumentsOf() writes it; true when one did.
bool takeArguments(const QString& text, targeting::MethodReportOptions& options);

}  // namespace pmts::app
