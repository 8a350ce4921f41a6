#pragma once

#include <QIcon>

#include <functional>

class QPainter;

namespace pmts::gui {

/// An icon that is painted anew at every size, in the colours of the palette in use.
using PaintIcon = std::function<void(QPainter&, const QRect&, QIcon::Mode, QIcon::State)>;
[[nodiscard]] QIcon paintedIcon(PaintIcon paint);

}  // namespace pmts::gui
