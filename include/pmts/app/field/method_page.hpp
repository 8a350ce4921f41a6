#pragma once

#include "pmts/app/settings/unit_format.hpp"
#include "pmts/targeting/method_report.hpp"

#include <QPointF>
#include <QSize>
#include <QStringList>

#include <vector>

namespace pmts::app {

/// Rows of texts under a header.
struct TextTable {
    QStringList header;
    std::vector<QStringList> rows;
    int plain_rows = 0;  ///< the rows after these sum up: rms, maximum
};

/// How far a method was off at a target, in the page's unit: computed less observed.
struct TargetError {
    QString name;
    double ha = 0.0, va = 0.0;
    QPointF px;  ///< where the target is in the photo
};

/// One method over the list, ready to be shown.
struct MethodPage {
    QString name;  ///< `APA`
    QString title, setting, known_error;
    QString off_printed;  ///< largest difference from the printed columns; empty without them
    TextTable table;
    std::vector<TargetError> errors;  ///< of those that were computed
};

/// All of a method report, in the user's units.
struct MethodReportView {
    QString head;          ///< targets, photo
    QStringList fit;       ///< quality and parameters of the fitted rig; empty without a fit
    TextTable summary;     ///< one row a method
    std::vector<MethodPage> pages;
    QSize image_px;
    QString plot_unit;     ///< of TargetError: gon, ° or mil
};

[[nodiscard]] MethodReportView methodReportView(const std::vector<targeting::ListedTarget>& targets,
                                                const targeting::MethodReportOptions& options, const UnitFormat& units);

/// The pages as one table, a line for each method and target; angles in the user's units.
[[nodiscard]] QString csvOf(const MethodReportView& view);

}  // namespace pmts::app
