#include "picture_tools.hpp"

#include "field_actions.hpp"

#include <utility>

namespace pmts::gui {

PictureTools::PictureTools(const FieldActions& actions, QObject* parent)
    : QObject(parent), actions_(actions) {
    const std::pair<QAction*, Tool> tools[] = {{actions.drag_turns, Tool::kDragTurn},
                                               {actions.zoom_box, Tool::kZoomBox},
                                               {actions.mark, Tool::kMark}};
    for (const auto& [action, tool] : tools) {
        connect(action, &QAction::toggled, this, [this, tool = tool](bool on) {
            if (on) {
                take(tool);
            } else if (tool_ == tool) {
                take(Tool::kAim);
            }
        });
    }
    connect(actions.stop, &QAction::triggered, this, &PictureTools::putAway);
}

void PictureTools::take(Tool tool) {
    if (tool != tool_) {
        tool_ = tool;
        Q_EMIT toolChanged(tool);
    }
}

void PictureTools::putAway() {
    Q_EMIT touched(nullptr);
    for (QAction* action : {actions_.drag_turns, actions_.zoom_box, actions_.mark}) {
        action->setChecked(false);
    }
}

}  // namespace pmts::gui
