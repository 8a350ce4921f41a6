#include "lab_step.hpp"

namespace pmts::gui {

bool LabStep::pictureClicked(const QPointF&) { return false; }

void LabStep::paintOver(QPainter&, const QTransform&) {}

}  // namespace pmts::gui
