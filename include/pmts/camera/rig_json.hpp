#pragma once

#include "pmts/camera/rig.hpp"
#include "pmts/core/result.hpp"

#include <QJsonObject>

namespace pmts::camera {

/// Version of the rig's JSON; a reader refuses a newer one.
inline constexpr int kRigJsonVersion = 1;

/// A rig as data, for the job file and for exchange. Units are in the names, numbers come back bit by bit:
///     {"version": 1, "width_px": 1280, "height_px": 720,
///      "lens": {"model": "brown", "f_px": ..., "cx_px": ..., "cy_px": ..., "k1": ..., "k2": ..., "k3": ...,
///      "p1": ..., "p2": ...}
///           or {"model": "radial_table", "cx_px": ..., "cy_px": ..., "rows": [[radius_px, angle_rad], ...]},
///      "mount": {"kind": "telescope" or "handle", "offset_m": [Xo, Yo, Zo], "yaw_gon": ..., "pitch_gon":
///      ..., "twist_gon": ...}}
[[nodiscard]] QJsonObject rigToJson(const Rig& rig);

/// Fails with ErrorKind::kBadInput and names the entry that is missing or makes no camera.
/// k1 to p2, yaw, pitch and twist may be left out: they are then zero.
[[nodiscard]] core::Result<Rig> rigFromJson(const QJsonObject& json);

}  // namespace pmts::camera
