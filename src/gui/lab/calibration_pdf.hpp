#pragma once

#include "pmts/app/lab/calibration_report.hpp"
#include "pmts/core/result.hpp"

#include <opencv2/core/mat.hpp>

namespace pmts::gui {

/// The report of a calibration as a PDF, A4: facts and parameters, then the four figures, then the checks. kFile when it
/// cannot be written.
[[nodiscard]] core::Result<void> writeCalibrationPdf(const app::CalibrationReport& report, const QString& path);

/// A board to print, in its true size on a page of A4 or A3 (the smaller one that holds it). `cells`: black and white, each `cell_mm`
/// wide. kBadInput when no page holds it; kFile when it cannot be written.
[[nodiscard]] core::Result<void> writeBoardPdf(const cv::Mat& cells, double cell_mm, const QString& caption, const QString& path);

}  // namespace pmts::gui
