#pragma once

#include "pmts/app/desk/workbench.hpp"

#include <QMenu>

namespace pmts::gui {

/// Adds the method report and the APA measurement to the Tools menu; each window is made when it is first opened.
void addMethodTools(QMenu& tools, app::Workbench& bench, QWidget* window);

}  // namespace pmts::gui
