#pragma once

#include "pmts/camera/rig.hpp"

#include <QString>

#include <optional>

namespace pmts::simulator {

/// The lens the simulated camera truly has.
enum class CameraLens {
    kBrown,     ///< a webcam's, 1280x720: what the first start knows of it is true
    kRational,  ///< a wide action camera's, which bends more and otherwise than Brown's model can
    kFisheye,   ///< 107 degrees from corner to corner
    kThesis,    ///< the thesis's Microsoft LifeCam HD-5000 at 640x480
};

/// What the simulated camera is and how it is strapped on.
struct CameraChoice {
    CameraLens lens = CameraLens::kBrown;
    camera::MountKind mount = camera::MountKind::kTelescope;
    /// Not 0: somebody knocked it. The camera has moved by up to 8 mm and turned by up to 0.8 gon about each
    /// axis, otherwise for each seed.
    unsigned rig_error = 0;
};

/// `brown`, `rational`, `fisheye` or `thesis`.
[[nodiscard]] std::optional<CameraLens> cameraLensFromText(const QString& text);

/// The true rig of the simulated camera: strapped to the telescope 12 mm right of, 85 mm before and 52 mm
/// above the optical centre, a little turned against the line of sight, with a lens that bends like a
/// webcam's. Seeded data: a program may hand the same numbers to its user as the profile that a careful
/// calibration would have found.
[[nodiscard]] camera::Rig simulatedRig();
/// The true rig of another one.
[[nodiscard]] camera::Rig simulatedRig(const CameraChoice& choice);

/// The lens of the thesis's figures 5.14 and 5.15: a pixel is 0.083719 gon wide at the centre and 0.066547
/// gon at pixel 290, where the angle has fallen 1.48121 gon behind a straight line of central pixels. Past
/// its last measured row the pixels keep their width.
[[nodiscard]] camera::Lens thesisLens();

}  // namespace pmts::simulator
