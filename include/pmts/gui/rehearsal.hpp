#pragma once

#include "pmts/core/result.hpp"
#include "pmts/core/task.hpp"

#include <QString>

#include <vector>

namespace pmts::app {
class Workbench;
}

namespace pmts::gui {

class MainWindow;

/// A target whose true place is known: metres in the simulator's station frame, origin at the optical centre.
struct KnownMark {
    QString name;
    double x_m = 0.0, y_m = 0.0, z_m = 0.0;
};

struct RehearsalPlan {
    QString folder;                  ///< where the job, the CSV and the pictures go; exists
    std::vector<KnownMark> marks;    ///< at least three, in the order they are measured
    double largest_error_m = 0.015;  ///< of a recorded point against its mark
};

/// Drives the real window through the main job by clicks and keys, as a surveyor would: station, capture,
/// aim, turn, refine, measure, record, codes, plan, dialogs, palettes, export. Leaves points.csv and a
/// picture of every step. Fails with the sentence of the first step that did not come about within its limit.
[[nodiscard]] core::Task<core::Result<void>> rehearse(MainWindow& window, app::Workbench& bench,
                                                      RehearsalPlan plan);

}  // namespace pmts::gui
