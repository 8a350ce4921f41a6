#pragma once

#include "pmts/calibration/rig_fit.hpp"
#include "pmts/camera/residual_table.hpp"

#include <Eigen/Core>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

namespace pmts::calibration {

/// The spot in one picture of a sweep.
struct SpotPicture {
    geometry::Pointing at{};  ///< circle readings, either face
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
};

/// One natural spot, and where it was seen while the instrument turned.
struct SweptSpot {
    geometry::PolarPoint about{};    ///< where it is: roughly, or as sighted; its range measured or assumed
    bool range_measured = false;     ///< else offsets keep their size
    bool direction_sighted = false;  ///< somebody put the cross-hair on it: its direction is not an unknown
    std::vector<SpotPicture> pictures;
};

struct SelfCalibrationOptions {
    camera::Rig start;           ///< what is known of the camera; its table of residuals is not used
    bool residual_table = true;  ///< try one on top, keep it where it makes held-out residuals smaller
    int folds = 10;              ///< parts left out one after the other
    double table_gain = 0.97;    ///< held-out residuals with the table over those without: at most this
    /// Distortion sets to choose from, simplest first; the simplest within 4 % of the best held-out residual
    /// wins.
    std::vector<std::vector<RigParameter>> distortions{
        {RigParameter::kK1},
        {RigParameter::kK1, RigParameter::kK2},
        {RigParameter::kK1, RigParameter::kK2, RigParameter::kP1, RigParameter::kP2},
        {RigParameter::kK1, RigParameter::kK2, RigParameter::kK3},
        {RigParameter::kK1, RigParameter::kK2, RigParameter::kK3, RigParameter::kP1, RigParameter::kP2},
    };
};

/// A parameter the sightings cannot tell from others: it was held at its start.
struct HeldParameter {
    RigParameter parameter = RigParameter::kOffsetY;
    QString sentence;  ///< why, and what to do
};

/// How one distortion set did.
struct DistortionTrial {
    std::vector<RigParameter> distortion;
    double held_out_px = 0.0;
};

struct SelfCalibration {
    camera::Rig rig;
    std::vector<geometry::PolarPoint> spots;    ///< as solved
    std::vector<ParameterEstimate> parameters;  ///< free ones
    std::vector<HeldParameter> held;
    Eigen::MatrixXd correlation;  ///< of `parameters`, in their order
    /// Over all pictures, spot after spot: modelled less seen pixel, the table of residuals included.
    std::vector<Eigen::Vector2d> residuals_px;
    std::vector<std::size_t> outliers;  ///< of all pictures; not used
    double rms_px = 0.0;                ///< over the coordinates used
    double held_out_px = 0.0;           ///< the same of pictures that did not take part in the fit
    double held_out_without_table_px = 0.0;
    std::vector<DistortionTrial> trials;

    [[nodiscard]] bool hasTable() const { return rig.lens.residuals().has_value(); }
};

/// Solves the camera from sweeps of one or more spots: focal length, principal point, distortion, rotations,
/// offsets and the direction of each spot. kBadInput when there are too few pictures, kUndefined when it does
/// not settle, kCancelled when `go_on` says so; it is told how much is done (0 to 1). Any thread.
[[nodiscard]] core::Result<SelfCalibration> selfCalibrate(const std::vector<SweptSpot>& spots,
                                                          const SelfCalibrationOptions& options,
                                                          const std::function<bool(double done)>& go_on = {});

/// Focal length, distortion and rotations from a few pictures of scouting sweeps, the more of the lens the
/// further out they reach: enough to find the spot again a step nearer to the corners.
[[nodiscard]] core::Result<camera::Rig> roughRig(const std::vector<SweptSpot>& spots,
                                                 const camera::Rig& start);

/// `offset to the right`, `focal length`: without a unit.
[[nodiscard]] QString parameterWords(RigParameter parameter);
/// What a surveyor wants to know of it, a sentence each: how good, what is not known, which pictures were
/// refused.
[[nodiscard]] QStringList verdict(const SelfCalibration& calibration);

}  // namespace pmts::calibration
