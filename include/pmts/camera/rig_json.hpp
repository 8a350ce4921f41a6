#pragma once

#include "pmts/camera/rig.hpp"
#include "pmts/core/result.hpp"

#include <QJsonObject>

namespace pmts::camera {

/// Version of the rig's JSON; a reader refuses a newer one. Version 2 added the rational lens, the fisheye and the
/// table of residuals; version 1 is read as ever.
inline constexpr int kRigJsonVersion = 2;

/// A rig as data, for the job file and for exchange. Units are in the names, numbers come back bit by bit:
///     {"version": 2, "width_px": 1280, "height_px": 720,
///      "lens": {"model": "brown", "f_px": ..., "cx_px": ..., "cy_px": ..., "k1": ..., "k2": ..., "k3": ...,
///      "p1": ..., "p2": ...}
///           or {"model": "radial_table", "cx_px": ..., "cy_px": ..., "rows": [[radius_px, angle_rad], ...]}
///           or {"model": "rational", ... as brown, "k4", "k5", "k6"}
///           or {"model": "fisheye", "f_px", "cx_px", "cy_px", "k1", "k2", "k3", "k4"},
///           any of them with "residuals": {"left_px", "top_px", "step_x_px", "step_y_px", "columns", "rows",
///           "nodes_px": [[dx, dy], ...]},
///      "mount": {"kind": "telescope" or "handle", "offset_m": [Xo, Yo, Zo], "yaw_gon": ..., "pitch_gon":
///      ..., "twist_gon": ...}}
[[nodiscard]] QJsonObject rigToJson(const Rig& rig);

/// Fails with ErrorKind::kBadInput and names the entry that is missing or makes no camera.
/// k1 to p2 (k6 for a rational lens), yaw, pitch and twist may be left out: they are then zero.
[[nodiscard]] core::Result<Rig> rigFromJson(const QJsonObject& json);

}  // namespace pmts::camera
