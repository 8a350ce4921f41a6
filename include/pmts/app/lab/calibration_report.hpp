#pragma once

#include "pmts/app/lab/rig_profile.hpp"
#include "pmts/app/settings/unit_format.hpp"

#include <QPointF>
#include <QStringList>

#include <utility>
#include <vector>

namespace pmts::app {

/// Everything that the report of a calibration shows, as texts and points; made from the rig and its record alone, so that
/// every method has the same report.
struct CalibrationReport {
    QString title;                                       ///< name of the profile
    std::vector<std::pair<QString, QString>> facts;      ///< camera, mode, method, date ...
    struct Parameter {
        QString name, value, deviation;
    };
    std::vector<Parameter> parameters;
    QSize image_px;
    std::vector<RecordedResidual> residuals;             ///< vectors, and their length over the radius
    QPointF centre_px;
    std::vector<QPointF> angle_curve;                    ///< px off the principal point -> gon off the axis (thesis fig. 5.14)
    std::vector<QPointF> ideal_curve;                    ///< atan(r / f)
    std::vector<QPointF> width_curve;                    ///< px -> gon per pixel (fig. 5.15)
    struct Check {
        QString date, target, result, state;
    };
    std::vector<Check> checks;                           ///< newest first
    QString compared;                                    ///< with the calibration before it; empty when there is none
};

[[nodiscard]] CalibrationReport calibrationReport(const RigProfile& profile, const UnitFormat& units);
/// The same as lines of text, for the clipboard.
[[nodiscard]] QString calibrationReportText(const CalibrationReport& report);

}  // namespace pmts::app
