#pragma once

#include <QIcon>
#include <QString>

namespace pmts::gui {

/// Makes icons and style sheet of resources/ available; cheap to call again.
void useResources();

/// A line icon of resources/icons, drawn in the colour of the current palette: it follows a change of palette
/// by itself. On checked and default buttons it takes the colour of text on the accent.
[[nodiscard]] QIcon lineIcon(const QString& name);

}  // namespace pmts::gui
