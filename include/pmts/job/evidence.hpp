#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/geometry/pointing.hpp"

#include <QByteArray>
#include <QDateTime>
#include <QPointF>
#include <QString>

#include <optional>

namespace pmts::job {

/// A small picture of an aiming: PNG or JPEG bytes, and what to draw into it. Pixels of this picture.
struct EvidencePicture {
    QByteArray encoded_image;           ///< empty: there was no picture
    std::optional<QPointF> spot_px;     ///< what was aimed at; absent outside the picture
    std::optional<QPointF> reticle_px;  ///< where the telescope's axis met the view
};

/// How a point was aimed by image, and how well: one row a point, written with it and never changed.
/// Residual, score, runner-up and sigma are absent when nothing was looked for after the last move (open
/// loop).
struct Evidence {
    qint64 row_id = 0;  ///< of the job file; 0: not stored yet
    qint64 point_row = 0;
    QString method;  ///< `rigorous`, `TPA`, `OATPA`, ...
    bool recentred = false;
    geometry::Pointing pointing;          ///< circle readings after the last move
    std::optional<double> residual_x_px;  ///< the spot against the reticle, right
    std::optional<double> residual_y_px;  ///< down
    std::optional<core::Angle> residual;
    double tolerance_px = 0.0;  ///< settled when either tolerance holds
    core::Angle tolerance{};
    std::optional<double> score;      ///< correlation coefficient, 1 is perfect
    std::optional<double> runner_up;  ///< best score of anything else
    std::optional<double> sigma_px;
    int moves = 0;
    double slope_distance_m = 0.0;  ///< the reticle was drawn for it
    QString slope_distance_source;  ///< `measured`, `last shot`, `assumed`
    QDateTime utc;
    EvidencePicture before;  ///< when it was clicked
    EvidencePicture after;   ///< after the last move
};

}  // namespace pmts::job
