#pragma once

#include "pmts/core/angle.hpp"
#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"
#include "pmts/survey/station.hpp"

#include <Eigen/Core>
#include <QDateTime>
#include <QString>

#include <functional>
#include <optional>

namespace pmts::survey {

/// What the instrument said about one shot, never changed after it was recorded (design, section 7).
struct Observation {
    geometry::Pointing pointing;             ///< circle readings
    std::optional<double> slope_distance_m;  ///< absent: angles only, or absurd
    QString absurd_reason;                   ///< set when the distance is absurd
    double target_height_m = 0.0;
    QString edm_mode;           ///< STD, TRK, D-bar, FSTD, D-bar HR
    double time_taken_s = 0.0;  ///< TT
    QDateTime utc;
    QString raw_reply;                        ///< bytes of the block, for the record
    QString source = QStringLiteral("pmts");  ///< pmts, or reg_key / slave for blocks nobody asked for
};

/// Accuracy of an instrument, one sigma, as makers print it.
struct InstrumentAccuracy {
    core::Angle angle = core::Angle::fromCc(10);
    double distance_m = 0.003;
    double distance_ppm = 3.0;
};

/// E, N, H with their precision, one sigma, metres.
struct Coordinates {
    double e_m = 0.0, n_m = 0.0, h_m = 0.0;
    double sigma_e_m = 0.0, sigma_n_m = 0.0, sigma_h_m = 0.0;

    [[nodiscard]] double sigma3dM() const;
};

/// E = E0 + SD sin(VA) sin(HA + orientation), N with cosine, H = H0 + ih - th + SD cos(VA); variances
/// propagated from `accuracy` (angles and distance uncorrelated, station without error). Both faces give the
/// same point. Source: PMTS reference, section 4; not the thesis's eq. 4.1-4.3, which swap E and N and take
/// 22/7 for pi. Fails with kAbsurdPoint when the observation has no distance.
[[nodiscard]] core::Result<Coordinates> coordinatesOf(const Station& station, const Observation& observation,
                                                      const InstrumentAccuracy& accuracy);

/// Position of a ground-system point in the station frame of section 4 (origin: optical centre, y at circle
/// reading 0). `target_height_m` is the height of the mark above the point.
[[nodiscard]] Eigen::Vector3d stationFrameFromGround(const Station& station, double e_m, double n_m,
                                                     double h_m, double target_height_m);

/// One recorded point: derived from its observation, with what the surveyor called it.
struct Point {
    qint64 row_id = 0;  ///< of the job file; 0: not recorded yet
    QString id;
    QString code;
    QString remark;
    bool struck_out = false;  ///< undone: kept, not drawn, not exported
    QString station_name;
    Observation observation;
    Coordinates coordinates;  ///< of no meaning without hasCoordinates()

    /// False for an absurd point and for a direction without a distance: not drawn, not computed with.
    [[nodiscard]] bool hasCoordinates() const { return observation.slope_distance_m.has_value(); }
};

/// The ID after `id`: its last run of digits is counted up, width kept: A09 -> A10, WALL -> WALL1, 104 -> 105.
[[nodiscard]] QString nextPointId(const QString& id);
/// `id` itself when nobody uses it, else the first ID after it that is free.
[[nodiscard]] QString freePointId(QString id, const std::function<bool(const QString&)>& is_used);

}  // namespace pmts::survey
