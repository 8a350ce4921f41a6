#pragma once

#include "pmts/camera/rig.hpp"
#include "pmts/core/result.hpp"
#include "pmts/geometry/polar.hpp"

#include <Eigen/Core>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace pmts::calibration {

/// What a fit may change. Lengths of the picture in px, angles in rad, offsets in m, distortion without unit.
enum class RigParameter {
    kFocalLength,
    kCentreX,
    kCentreY,
    kK1,
    kK2,
    kK3,
    kP1,
    kP2,
    kYaw,
    kPitch,
    kTwist,
    kOffsetX,
    kOffsetY,
    kOffsetZ,
};

/// The eight unknowns that explain the thesis's own photo (PMTS reference, section 9).
[[nodiscard]] std::vector<RigParameter> thesisParameters();

/// Short name with its unit, e.g. "pitch [rad]".
[[nodiscard]] QString parameterName(RigParameter parameter);

/// One target seen in a photo and sighted with the telescope.
struct Sighting {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();  ///< where it is in the photo
    geometry::Pointing at{};                       ///< circle readings when the photo was taken
    geometry::PolarPoint target{};  ///< readings and slope distance when the telescope was on it
};

struct ParameterEstimate {
    RigParameter parameter = RigParameter::kFocalLength;
    double value = 0.0;
    /// Absent when the sightings cannot tell this parameter from the others: it then stayed near its start.
    std::optional<double> standard_deviation;

    [[nodiscard]] bool determinable() const { return standard_deviation.has_value(); }
};

struct RigFit {
    camera::Rig rig;                            ///< the initial rig with the fitted parameters
    double rms_px = 0.0;                        ///< over all coordinates, two for each sighting
    double largest_px = 0.0;                    ///< largest residual of a coordinate
    int redundancy = 0;                         ///< coordinates less parameters
    std::vector<Eigen::Vector2d> residuals_px;  ///< model minus observed, in the order given
    std::vector<ParameterEstimate> parameters;  ///< in the order given
};

/// Least squares of the pixel residuals over the free parameters; the others keep the initial rig's values.
/// Standard deviations are scaled by the residuals themselves (sigma0^2 = sum of squares / redundancy).
/// kBadInput when there are too few sightings, one has no pixel in the initial rig (it is named), or the lens
/// is a table; kUndefined when the solution does not settle.
[[nodiscard]] core::Result<RigFit> fitRig(const std::vector<Sighting>& sightings, const camera::Rig& initial,
                                          const std::vector<RigParameter>& free);

/// The rig fitted without the i-th sighting, for each i: what it makes of that one is what a new target may
/// expect. Fails like fitRig(), naming no sighting, when one of the fits does. `go_on` is told how many are
/// done before each fit; false ends it with kCancelled.
[[nodiscard]] core::Result<std::vector<camera::Rig>> fitWithoutEach(
    const std::vector<Sighting>& sightings, const camera::Rig& initial, const std::vector<RigParameter>& free,
    const std::function<bool(std::size_t done)>& go_on = {});

/// The same sightings explained by a camera on the handle and by one on the telescope.
struct MountComparison {
    RigFit handle;
    RigFit telescope;
    camera::MountKind likelier = camera::MountKind::kTelescope;
    /// Larger over smaller variance of the residuals. Below 2.5 (the 95 % point of F at the 14 degrees of
    /// freedom of the thesis's photo) the sightings do not tell the mounts apart.
    double variance_ratio = 1.0;

    [[nodiscard]] bool decisive() const { return variance_ratio >= 2.5; }
    [[nodiscard]] const RigFit& likelierFit() const {
        return likelier == camera::MountKind::kHandle ? handle : telescope;
    }
};

/// Fits both mounts. At one telescope tilt a free pitch makes them the same model: leave pitch out of `free`
/// there, or sight targets at two tilts.
[[nodiscard]] core::Result<MountComparison> compareMounts(const std::vector<Sighting>& sightings,
                                                          const camera::Rig& initial,
                                                          const std::vector<RigParameter>& free);

}  // namespace pmts::calibration
