#pragma once

#include "pmts/camera/residual_table.hpp"
#include "pmts/core/result.hpp"

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <variant>
#include <vector>

namespace pmts::camera {

/// Brown's model as OpenCV defines it: x = X/Z, y = Y/Z, r2 = x2 + y2,
///     x' = x (1 + k1 r2 + k2 r4 + k3 r6) + 2 p1 x y + p2 (r2 + 2 x2),   u = cx + f x'
///     y' = y (1 + k1 r2 + k2 r4 + k3 r6) + p1 (r2 + 2 y2) + 2 p2 x y,   v = cy + f y'
/// Camera frame: x right, y down, z along the optical axis (OpenCV's).
struct BrownLens {
    double f_px = 1000.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    double k1 = 0.0, k2 = 0.0, k3 = 0.0, p1 = 0.0, p2 = 0.0;

    [[nodiscard]] bool operator==(const BrownLens&) const = default;
};

/// OpenCV's rational model: Brown's with the radial factor
///     (1 + k1 r2 + k2 r4 + k3 r6) / (1 + k4 r2 + k5 r4 + k6 r6)
struct RationalLens {
    double f_px = 1000.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    double k1 = 0.0, k2 = 0.0, k3 = 0.0, k4 = 0.0, k5 = 0.0, k6 = 0.0, p1 = 0.0, p2 = 0.0;

    [[nodiscard]] bool operator==(const RationalLens&) const = default;
};

/// OpenCV's fisheye (Kannala and Brandt 2006): the radius in the picture over the angle t off the axis,
///     r = f t (1 + k1 t2 + k2 t4 + k3 t6 + k4 t8)
struct FisheyeLens {
    double f_px = 1000.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    double k1 = 0.0, k2 = 0.0, k3 = 0.0, k4 = 0.0;

    [[nodiscard]] bool operator==(const FisheyeLens&) const = default;
};

/// The thesis's distortion table: the true angle off the axis at each radius, radially symmetric about the
/// centre, interpolated shape preserving (thesis 5.5.1.7).
struct RadialTableLens {
    struct Row {
        double radius_px = 0.0;
        double angle_rad = 0.0;

        [[nodiscard]] bool operator==(const Row&) const = default;
    };
    double cx_px = 0.0;
    double cy_px = 0.0;
    std::vector<Row> rows;  ///< strictly increasing in both columns, the first is (0, 0)

    [[nodiscard]] bool operator==(const RadialTableLens&) const = default;
};

using LensModel = std::variant<BrownLens, RadialTableLens, RationalLens, FisheyeLens>;

/// A lens: which direction in the camera frame each pixel sees. A model, and on top of it, when there is one,
/// a table of what the model leaves over. A value; copy it freely.
class Lens {
public:
    Lens() = default;
    explicit Lens(const BrownLens& model);     ///< throws std::logic_error unless f_px > 0 and all are finite
    explicit Lens(const RationalLens& model);  ///< likewise
    explicit Lens(const FisheyeLens& model);   ///< likewise
    explicit Lens(RadialTableLens model);      ///< throws std::logic_error when the table is not monotone

    /// The same model with this table on top, or with none. Throws std::logic_error when the table folds.
    [[nodiscard]] Lens withResiduals(std::optional<ResidualTable> table) const;

    /// Pixel of a point in the camera frame (any length). kUndefined behind the camera, past the model's fold
    /// (where the radius in the picture stops growing with the angle) or past the last row of the table.
    [[nodiscard]] core::Result<Eigen::Vector2d> pixelFromCamera(const Eigen::Vector3d& p_camera) const;
    /// Unit vector in the camera frame. kUndefined where the model has no inverse. Round trip within 1e-6 px.
    [[nodiscard]] core::Result<Eigen::Vector3d> cameraFromPixel(const Eigen::Vector2d& px) const;
    [[nodiscard]] Eigen::Vector2d principalPoint() const;
    /// Pixels per radian at the axis.
    [[nodiscard]] double focalLengthPx() const;
    /// Angle off the axis up to which the model holds: the fold, the last row, or 100 gon (fisheye: 200 gon).
    [[nodiscard]] double usableAngle_rad() const;
    [[nodiscard]] const LensModel& model() const { return model_; }
    [[nodiscard]] const std::optional<ResidualTable>& residuals() const { return residuals_; }

private:
    [[nodiscard]] core::Result<Eigen::Vector2d> modelledPixel(const Eigen::Vector3d& p_camera) const;
    [[nodiscard]] std::optional<Eigen::Vector3d> modelledRay(const Eigen::Vector2d& px) const;

    LensModel model_ = BrownLens{};
    /// Brown, rational: x2 + y2 at the fold. Fisheye: angle there, rad.
    double fold_ = std::numeric_limits<double>::infinity();
    std::vector<double> slopes_;  ///< radial table: d angle / d radius at each row
    std::optional<ResidualTable> residuals_;
};

}  // namespace pmts::camera
