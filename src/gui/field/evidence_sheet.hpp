#pragma once

#include "pmts/app/field/evidence_presenter.hpp"
#include "pmts/core/result.hpp"

#include <QPainter>

namespace pmts::gui {

/// Draws the evidence of a point onto one page, A4 upright: black on white whatever the palette. In units
/// of a tenth of a millimetre, 2100 x 2970: see usePageUnits().
void paintEvidenceSheet(QPainter& painter, const app::EvidenceSheet& sheet);

/// The sheet as a PDF of one page. The file appears whole or not at all; kFile with the reason otherwise.
[[nodiscard]] core::Result<void> writeEvidencePdf(const app::EvidenceSheet& sheet, const QString& path);

/// Scales the painter of a page of A4, full page, to tenths of a millimetre.
void usePageUnits(QPainter& painter, int dots_per_inch);

}  // namespace pmts::gui
