#pragma once

#include "pmts/app/field/evidence_presenter.hpp"

#include <QPainter>

namespace pmts::gui {

/// Draws a picture of an aiming as large as it fits into `room`, with its reticle (cross) and the spot that
/// was aimed at (ring); `line` is the width of a stroke. Says so where no picture was kept. Returns what it
/// covers.
QRectF paintThumbnail(QPainter& painter, const QRectF& room, const app::EvidenceThumbnail& thumbnail,
                      double line);

}  // namespace pmts::gui
