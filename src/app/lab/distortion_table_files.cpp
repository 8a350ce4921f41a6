// The distortion table's files and plots.
#include "pmts/app/lab/distortion_table_presenter.hpp"

#include <QFile>
#include <QSaveFile>

namespace pmts::app {

namespace {

constexpr qint64 kLargestFile = 1 << 20;
constexpr int kPlotPoints = 60;

double gon(double rad) { return core::Angle::fromRad(rad).gon(); }

TablePlots::Curve widthsOf(const QString& name, const std::vector<camera::RadialTableLens::Row>& rows, bool measured) {
    TablePlots::Curve curve{.name = name, .radius_px = {}, .value_gon = {}, .measured = measured};
    for (const calibration::PixelWidth& width : calibration::pixelWidths(rows)) {
        curve.radius_px.push_back(width.radius_px);
        curve.value_gon.push_back(gon(width.width_rad));
    }
    return curve;
}

TablePlots::Curve anglesOf(const QString& name, const std::vector<camera::RadialTableLens::Row>& rows, bool measured) {
    TablePlots::Curve curve{.name = name, .radius_px = {}, .value_gon = {}, .measured = measured};
    for (const auto& row : rows) {
        curve.radius_px.push_back(row.radius_px);
        curve.value_gon.push_back(gon(row.angle_rad));
    }
    return curve;
}

}  // namespace

TablePlots DistortionTablePresenter::plots() const {
    TablePlots plots;
    for (const calibration::TableCurve& curve : curves_) {
        const QString name = tr("%1, %2").arg(preferences_.units().length(curve.distance_m), calibration::directionName(curve.direction));
        plots.angle.push_back(anglesOf(name, curve.rows, true));
        plots.width.push_back(widthsOf(name, curve.rows, true));
    }
    if (!canAccept()) {
        return plots;
    }
    plots.angle.push_back(anglesOf(tr("table"), rows_, false));
    plots.width.push_back(widthsOf(tr("table"), rows_, false));
    const double width_rad = calibration::centralPixelWidth_rad(rows_);
    TablePlots::Curve line{.name = tr("ideal line"), .radius_px = {}, .value_gon = {}, .measured = false};
    TablePlots::Curve lens{.name = tr("ideal lens"), .radius_px = {}, .value_gon = {}, .measured = false};
    TablePlots::Curve lens_width = lens;
    for (int i = 0; i <= kPlotPoints; ++i) {
        const double radius_px = rows_.back().radius_px * i / kPlotPoints;
        line.radius_px.push_back(radius_px);
        line.value_gon.push_back(gon(calibration::idealLineAngle_rad(width_rad, radius_px)));
        lens.radius_px.push_back(radius_px);
        lens.value_gon.push_back(gon(calibration::idealLensAngle_rad(width_rad, radius_px)));
        lens_width.radius_px.push_back(radius_px);
        lens_width.value_gon.push_back(gon(width_rad / (1 + width_rad * width_rad * radius_px * radius_px)));
    }
    plots.angle.push_back(line);
    plots.angle.push_back(lens);
    plots.width.push_back(lens_width);
    return plots;
}

void DistortionTablePresenter::importCsv(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return say(tr("The table cannot be read: %1.").arg(file.errorString()));
    }
    const auto table = calibration::tableFromCsv(file.read(kLargestFile));
    if (!table) {
        return say(table.error().sentence());
    }
    rows_ = table->rows;
    table_centre_ = {table->cx_px, table->cy_px};
    spread_rad_.clear();
    is_edited_ = true;
    is_accepted_ = false;
    say({});
}

void DistortionTablePresenter::exportCsv(const QString& path) {
    const camera::RadialTableLens table{.cx_px = table_centre_.x(), .cy_px = table_centre_.y(), .rows = rows_};
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(calibration::tableToCsv(table)) < 0 || !file.commit()) {
        return say(tr("The table cannot be written: %1.").arg(file.errorString()));
    }
    messages_.toast(tr("The table is saved."));
}

}  // namespace pmts::app
