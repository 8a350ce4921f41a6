#include "calibration_plots.hpp"

#include <QCoreApplication>

#include <algorithm>

namespace pmts::gui {
namespace {

using Role = DrawnResidual::Role;

QString say(const char* text) { return QCoreApplication::translate("CalibrationPlots", text); }

CurvePlot::Curve computed(const QString& name, const std::vector<QPointF>& points) {
    CurvePlot::Curve curve{.name = name, .radius_px = {}, .value_gon = {}, .measured = false};
    for (const QPointF& point : points) {
        curve.radius_px.push_back(point.x());
        curve.value_gon.push_back(point.y());
    }
    return curve;
}

}  // namespace

DrawnResiduals residualsOf(const app::SelfCalibrationView& view) {
    DrawnResiduals drawn{.residuals = {}, .frame_px = view.frame_px, .centre_px = view.centre_px};
    for (const app::PlottedResidual& residual : view.residuals) {
        drawn.residuals.push_back({residual.px, residual.residual_px, residual.outlier ? Role::kLeftOut : Role::kUsed, residual.spot + 1});
    }
    return drawn;
}

DrawnResiduals residualsOf(const app::CalibrationReport& report) {
    DrawnResiduals drawn{.residuals = {}, .frame_px = report.image_px, .centre_px = report.centre_px};
    for (const app::RecordedResidual& residual : report.residuals) {
        drawn.residuals.push_back({{residual.px.x(), residual.px.y()},
                                   {residual.residual_px.x(), residual.residual_px.y()},
                                   residual.held_out ? Role::kHeldOut : Role::kUsed});
    }
    return drawn;
}

std::vector<CurvePlot::Curve> angleCurvesOf(const app::CalibrationReport& report) {
    if (report.angle_curve.empty()) {
        return {};
    }
    const QPointF& edge = report.angle_curve.back();
    const QString ideal = say("ideal, %1 gon off at %2 px").arg(report.ideal_curve.back().y() - edge.y(), 0, 'f', 3).arg(edge.x(), 0, 'f', 0);
    return {computed(say("this lens"), report.angle_curve), computed(ideal, report.ideal_curve)};
}

std::vector<CurvePlot::Curve> widthCurvesOf(const app::CalibrationReport& report) {
    return report.width_curve.empty() ? std::vector<CurvePlot::Curve>() : std::vector{computed(say("this lens"), report.width_curve)};
}

CalibrationPlots::CalibrationPlots(QWidget* parent)
    : vectors_(new ResidualPlot(ResidualPlot::Kind::kVectors, parent)), radius_(new ResidualPlot(ResidualPlot::Kind::kRadius, parent)),
      angle_(new CurvePlot(parent)), width_(new CurvePlot(parent)) {
    for (ResidualPlot* const plot : {vectors_, radius_}) {
        plot->setNotice(say("This calibration kept no residuals."));
    }
    for (CurvePlot* const plot : {angle_, width_}) {
        plot->setNotice(say("This lens has no rays along its middle row."));
    }
    for (const auto& [heading, plot] : all()) {
        plot->setAccessibleName(heading);
    }
}

void CalibrationPlots::show(const app::CalibrationReport& report) {
    vectors_->showResiduals(residualsOf(report));
    radius_->showResiduals(residualsOf(report));
    angle_->showCurves(angleCurvesOf(report), say("angle off the axis, gon"));
    width_->showCurves(widthCurvesOf(report), say("width of a pixel, gon"));
}

std::array<std::pair<QString, PlotWidget*>, 4> CalibrationPlots::all() const {
    return {{{say("Residuals over the picture"), vectors_},
             {say("Residuals over the radius"), radius_},
             {say("Angle against pixel"), angle_},
             {say("Pixel width"), width_}}};
}

}  // namespace pmts::gui
