#include "calibration/sightings.hpp"
#include "self_calibration.hpp"
#include "support/figure.hpp"

#include <cmath>
#include <cstdio>

namespace pmts::bench {

void thesisPhoto() {
    using enum calibration::RigParameter;
    const auto sightings = test::thesisSightings();
    const auto fit = calibration::fitRig(sightings, test::thesisStart(), calibration::thesisParameters());
    const auto mounts = calibration::compareMounts(
        sightings, test::thesisStart(), {kFocalLength, kCentreX, kCentreY, kTwist, kOffsetY, kOffsetZ, kK1});
    if (!fit || !mounts) {
        std::fprintf(stderr, "%s\n", qPrintable((fit ? mounts.error() : fit.error()).sentence()));
        return;
    }
    figure("calibration.thesis_rms", fit->rms_px, "px", Wanted::kAtMost, 0.40);
    figure("calibration.thesis_largest", fit->largest_px, "px", Wanted::kAtMost, 0.80);
    figure("calibration.thesis_camera_off_level", std::abs(fit->rig.mount.pitch.gon()), "gon",
           Wanted::kAtMost, 2.0);
    std::printf(
        "# the camera was on the %s, variance ratio %.1f; pitch %.2f gon while the telescope stood at VA "
        "105.98\n",
        mounts->likelier == camera::MountKind::kHandle ? "handle" : "telescope", mounts->variance_ratio,
        fit->rig.mount.pitch.gon());
    figure("calibration.thesis_names_the_handle", mounts->likelier == camera::MountKind::kHandle ? 1 : 0, "",
           Wanted::kAtLeast, 1);
}

}  // namespace pmts::bench
