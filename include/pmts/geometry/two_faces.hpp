#pragma once

#include "pmts/core/result.hpp"
#include "pmts/geometry/pointing.hpp"

#include <optional>
#include <vector>

namespace pmts::geometry {

/// One target pointed at in both faces: circle readings.
struct FacePair {
    Pointing face_one, face_two;

    [[nodiscard]] bool operator==(const FacePair&) const = default;
};

/// Mean of both faces as a face I reading, HA in [0, 400) gon: free of collimation, index and tilting-axis error.
[[nodiscard]] Pointing meanOfFaces(const FacePair& pair);

/// What the faces differ by: HA I - (HA II - 200 gon), and VA I + VA II - 400 gon; both 0 for a perfect instrument.
struct FaceDifference {
    core::Angle ha, va;
};
[[nodiscard]] FaceDifference faceDifference(const FacePair& pair);

/// An error of the axes with its standard deviation; the latter absent with a single pointing.
struct AxisError {
    core::Angle value;
    std::optional<core::Angle> sigma;
};

/// What pairs of pointings say about an instrument.
struct AxisErrors {
    AxisError collimation;            ///< c: half the HA difference times sin VA
    AxisError index;                  ///< i: half the VA difference
    std::optional<AxisError> tilting; ///< of the tilting axis; absent where all targets are about equally high
    int pairs = 0;
};

/// Least squares over HA difference / 2 = c / sin VA + k cot VA (VA in face I). k is solved for where cot VA spreads by
/// more than 0.3 (targets 20 gon apart); else it is taken as 0, and leaks into c with k cos VA: use a target near the
/// horizon. Sigma is of the mean, from the residuals. kBadInput without a pair, kUndefined within 5 gon of the zenith.
[[nodiscard]] core::Result<AxisErrors> axisErrorsFrom(const std::vector<FacePair>& pairs);

}  // namespace pmts::geometry
