#pragma once

#include "pmts/camera/lens.hpp"
#include "pmts/camera/rig.hpp"
#include "pmts/core/angle_text.hpp"
#include "pmts/targeting/target_list.hpp"
#include "pmts/targeting/thesis_methods.hpp"

#include <QStringList>

#include <optional>
#include <vector>

namespace pmts::targeting {

enum class Method { kApa, kTpa, kOatpa, kRectifiedOatpa, kRigorous };

/// A rig fitted to the very targets of the report; the calibration room makes it.
struct FittedRig {
    camera::Rig rig;
    double rms_px = 0.0;
    double largest_px = 0.0;
    QStringList parameters;            ///< one line each: name, value, standard deviation
    std::vector<camera::Rig> without;  ///< fitted without the i-th target: its leave-one-out rig
};

/// What a method report is asked for.
struct MethodReportOptions {
    ThesisCamera camera;  ///< centre, f, offset; its pixel angle only when `pixel_angle_given`
    bool pixel_angle_given = false;
    double offset_right_m = 0.0;  ///< Xo; the thesis's methods leave it out, the nominal rig has it
    int width_px = 640;
    int height_px = 480;
    geometry::Pointing photo{core::Angle::fromGon(199.3587), core::Angle::fromGon(105.9808)};
    std::optional<camera::RadialTableLens> table;  ///< the distortion table; absent: made from the fit
    camera::MountKind nominal_mount = camera::MountKind::kHandle;
    /// The calibrated rig in use, for the rigorous method and the distortion table when nothing is fitted.
    std::optional<camera::Rig> rig{};
    std::optional<FittedRig> fit;  ///< absent, and no rig either: the rigorous method has the nominal camera
    core::AngleUnit angle_unit = core::AngleUnit::kGon;  ///< of all texts
};

struct MethodRow {
    core::Result<geometry::Pointing> computed;
    core::Angle error_ha, error_va;  ///< computed less observed; zero where nothing was computed
    /// Computed less printed, where somebody printed this method's result before.
    std::optional<core::Angle> off_printed_ha{}, off_printed_va{};
};

/// One of the thesis's tables.
struct MethodTable {
    Method method = Method::kApa;
    bool left_one_out = false;
    QString title;
    QString known_error;  ///< what is known of this method beforehand
    QString setting;      ///< what it was run with
    std::vector<MethodRow> rows;
    int computed = 0;
    core::Angle rms_ha, rms_va, largest_ha, largest_va;
    std::optional<core::Angle> off_printed;  ///< largest difference from the printed columns, when there are
};

/// All methods over the list, in the thesis's order; a method that cannot run has rows that say why. With a
/// fit, the last table is the rigorous method left-one-out: each target by the rig that never saw it.
[[nodiscard]] std::vector<MethodTable> runMethods(const std::vector<ListedTarget>& targets,
                                                  const MethodReportOptions& options);

/// Tables 6.1 to 6.4 of the thesis for the user's own list, as plain text.
[[nodiscard]] QString methodReport(const std::vector<ListedTarget>& targets,
                                   const MethodReportOptions& options);

}  // namespace pmts::targeting
