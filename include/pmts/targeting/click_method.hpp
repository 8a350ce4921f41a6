#pragma once

#include "pmts/targeting/method_report.hpp"
#include "pmts/targeting/pixel_to_pointing.hpp"
#include "pmts/targeting/thesis_methods.hpp"

#include <QString>

#include <optional>

namespace pmts::targeting {

/// How a click becomes a pointing: one of the thesis's methods or the rigorous one.
struct ClickMethod {
    Method method = Method::kRigorous;
    /// Measured as in the thesis, for APA; absent: the mean over the lens's picture.
    std::optional<AveragePixelAngle> measured_pixel_angle;
};

/// `Rigorous`, `Rectified OATPA`, …
[[nodiscard]] QString methodName(Method method);
/// What is wrong with it by itself, one line.
[[nodiscard]] QString methodError(Method method);

/// What the thesis's methods make of a calibrated rig: its f and offset, the mean angle of its pixels, and as
/// the photo's centre the pixel on which the axis falls far away.
[[nodiscard]] core::Result<ThesisCamera> thesisCamera(const PixelToPointing& model, const geometry::Pointing& at);

/// Circle readings for the clicked pixel, in the face of `at`. kUndefined where the model or the method has no
/// answer; the thesis's methods have none in face II.
[[nodiscard]] core::Result<geometry::Pointing> pointingOfClick(const ClickMethod& method,
                                                               const PixelToPointing& model,
                                                               const Eigen::Vector2d& px,
                                                               const geometry::Pointing& at,
                                                               double slope_distance_m);

}  // namespace pmts::targeting
