#pragma once

#include "pmts/app/desk/workbench.hpp"

class QMenu;

namespace pmts::gui {

/// The other end of the line: a control unit on a second port, the line setting that the instrument understands.
void addLineTools(QMenu& menu, app::Workbench& bench);

/// What hands and eyes do in a real laboratory, for the simulated one: choose the scene, look through the eyepiece at a mark,
/// turn the camera in its clamp.
void addLaboratoryTools(QMenu& menu, app::Workbench& bench);

/// `Connect the base on its bus`: a simulated one, instead of the instrument that is connected, and one whose start-up
/// fails beside the video unless its steps are time_critical (thesis 8.3.4). `owner` ends it.
void addSimulatedBus(QMenu& menu, app::Workbench& bench, QObject& owner);

}  // namespace pmts::gui
