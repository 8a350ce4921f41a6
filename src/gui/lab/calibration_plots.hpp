#pragma once

#include "curve_plot.hpp"
#include "pmts/app/lab/calibration_report.hpp"
#include "pmts/app/lab/self_calibration_view.hpp"
#include "parts/residual_plot.hpp"

#include <array>
#include <utility>

namespace pmts::gui {

[[nodiscard]] DrawnResiduals residualsOf(const app::SelfCalibrationView& view);
[[nodiscard]] DrawnResiduals residualsOf(const app::CalibrationReport& report);
/// Angle off the axis beside the ideal lens; empty when the lens has no rays along its middle row.
[[nodiscard]] std::vector<CurvePlot::Curve> angleCurvesOf(const app::CalibrationReport& report);
[[nodiscard]] std::vector<CurvePlot::Curve> widthCurvesOf(const app::CalibrationReport& report);

/// The four plots of a calibration's report, each with its heading, on the screen and on paper alike.
class CalibrationPlots {
public:
    /// The plots are the parent's children.
    explicit CalibrationPlots(QWidget* parent);

    void show(const app::CalibrationReport& report);
    [[nodiscard]] std::array<std::pair<QString, PlotWidget*>, 4> all() const;

private:
    ResidualPlot *vectors_, *radius_;
    CurvePlot *angle_, *width_;
};

}  // namespace pmts::gui
