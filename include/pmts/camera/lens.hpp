#pragma once

#include "pmts/core/result.hpp"

#include <Eigen/Core>

#include <limits>
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

/// A lens: which direction in the camera frame each pixel sees. A value; copy it freely.
class Lens {
public:
    Lens() = default;
    explicit Lens(const BrownLens& model);  ///< throws std::logic_error unless f_px > 0 and all are finite
    explicit Lens(RadialTableLens model);   ///< throws std::logic_error when the table is not monotone

    /// Pixel of a point in the camera frame (any length). kUndefined behind the camera, past the model's fold
    /// (where the radius in the picture stops growing with the angle) or past the last row of the table.
    [[nodiscard]] core::Result<Eigen::Vector2d> pixelFromCamera(const Eigen::Vector3d& p_camera) const;
    /// Unit vector in the camera frame. kUndefined where the model has no inverse. Round trip within 1e-6 px.
    [[nodiscard]] core::Result<Eigen::Vector3d> cameraFromPixel(const Eigen::Vector2d& px) const;
    [[nodiscard]] Eigen::Vector2d principalPoint() const;
    /// Pixels per radian at the axis.
    [[nodiscard]] double focalLengthPx() const;
    /// Angle off the axis up to which the model holds: the fold, the last row, or 100 gon.
    [[nodiscard]] double usableAngle_rad() const;
    [[nodiscard]] const std::variant<BrownLens, RadialTableLens>& model() const { return model_; }

private:
    std::variant<BrownLens, RadialTableLens> model_ = BrownLens{};
    double fold_r2_ = std::numeric_limits<double>::infinity();  ///< Brown: x2 + y2 at the fold
    std::vector<double> slopes_;                                ///< table: d angle / d radius at each row
};

}  // namespace pmts::camera
