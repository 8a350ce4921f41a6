#include "pmts/simulator/simulated_rig.hpp"

namespace pmts::simulator {

camera::Rig simulatedRig() {
    camera::Rig rig;
    rig.width_px = 1280;
    rig.height_px = 720;
    camera::BrownLens lens;
    lens.f_px = 1400.0;
    lens.cx_px = 643.5;  // four pixels beside the middle, as sensors are glued
    lens.cy_px = 357.5;
    lens.k1 = -0.12;
    lens.k2 = 0.02;
    rig.lens = camera::Lens(lens);
    rig.mount.kind = camera::MountKind::kTelescope;
    rig.mount.offset_m = {0.012, 0.085, 0.052};
    rig.mount.yaw = core::Angle::fromGon(0.15);
    rig.mount.pitch = core::Angle::fromGon(-0.2);
    rig.mount.twist = core::Angle::fromGon(0.3);
    return rig;
}

}  // namespace pmts::simulator
