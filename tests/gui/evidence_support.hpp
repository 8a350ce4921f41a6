#pragma once

#include "pmts/app/field/evidence_presenter.hpp"

namespace pmts::test {

/// A grey picture with a white spot, so that drawn marks are seen against it.
inline QImage pictureOfAWall() {
    QImage image(160, 90, QImage::Format_RGB888);
    image.fill(QColor(90, 110, 90));
    return image;
}

inline app::EvidenceSheet aimedSheet() {
    app::EvidenceSheet sheet;
    sheet.point_row = 7;
    sheet.job_name = QStringLiteral("facade-12");
    sheet.point_id = QStringLiteral("104");
    sheet.subtitle = QStringLiteral("WALL  ·  station 100");
    sheet.verdict = QStringLiteral("After 2 moves the spot was 0.05 px off the reticle.");
    sheet.place = {{QStringLiteral("E"), QStringLiteral("1003.500 m   ± 2.0 mm")},
                   {QStringLiteral("N"), QStringLiteral("1014.250 m   ± 3.0 mm")},
                   {QStringLiteral("H"), QStringLiteral("101.500 m   ± 1.0 mm")}};
    sheet.observation = {{QStringLiteral("HA"), QStringLiteral("12.3456 gon")},
                         {QStringLiteral("SD"), QStringLiteral("15.200 m   STD")}};
    sheet.aiming = {{QStringLiteral("Method"), QStringLiteral("rigorous, re-centred")},
                    {QStringLiteral("Known error"), QStringLiteral("that of the calibrated rig")},
                    {QStringLiteral("Match score"), QStringLiteral("0.974")}};
    sheet.before = {.caption = QStringLiteral("Before"),
                    .image = pictureOfAWall(),
                    .spot_px = QPointF(40, 20),
                    .reticle_px = {}};
    sheet.after = {.caption = QStringLiteral("After"),
                   .image = pictureOfAWall(),
                   .spot_px = QPointF(80, 45),
                   .reticle_px = QPointF(80, 45)};
    return sheet;
}

}  // namespace pmts::test
