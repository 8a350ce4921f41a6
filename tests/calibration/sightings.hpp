#pragma once

#include "pmts/calibration/rig_fit.hpp"
#include "targeting/icsm_table.hpp"

namespace pmts::test {

/// The thesis's 11 objects as sightings of its one photo.
inline std::vector<calibration::Sighting> thesisSightings() {
    std::vector<calibration::Sighting> sightings;
    for (const IcsmRow& row : icsmTable()) {
        sightings.push_back({.px = row.px, .at = icsmPhoto(), .target = row.observed});
    }
    return sightings;
}

/// What somebody knows before the fit: the nominal focal length, the centre of the photo, nothing shifted or
/// turned.
inline camera::Rig thesisStart(camera::MountKind kind = camera::MountKind::kHandle) {
    camera::Rig rig;
    rig.lens = camera::Lens(camera::BrownLens{.f_px = 784, .cx_px = 315, .cy_px = 240});
    rig.mount.kind = kind;
    rig.width_px = 640;
    rig.height_px = 480;
    return rig;
}

}  // namespace pmts::test
