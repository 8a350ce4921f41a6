#include "pmts/simulator/simulated_rig.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace pmts::simulator {
namespace {

/// Angle of the thesis's camera at a radius, gon: the width of a pixel falls with a power of the radius, the
/// one that makes both its figures true.
double thesisAngle_gon(double radius_px) {
    constexpr double kCentre_gon = 0.083719;
    constexpr double kEdge_gon = 0.066547;
    constexpr double kEdge_px = 290.0;
    constexpr double kBehind_gon = 1.48121;
    const double power = (kCentre_gon - kEdge_gon) * kEdge_px / kBehind_gon;  // one more than the width's
    const double inside = std::min(radius_px, kEdge_px);
    return kCentre_gon * inside - kBehind_gon * std::pow(inside / kEdge_px, power) +
           kEdge_gon * (radius_px - inside);
}

camera::Lens lensOf(CameraLens lens, const camera::Lens& webcam) {
    switch (lens) {
        case CameraLens::kBrown:
            return webcam;
        case CameraLens::kRational:
            return camera::Lens(camera::RationalLens{.f_px = 1000.0,
                                                     .cx_px = 646.2,
                                                     .cy_px = 355.1,
                                                     .k1 = 6.5,
                                                     .k2 = 3.2,
                                                     .k3 = 0.2,
                                                     .k4 = 6.9,
                                                     .k5 = 5.4,
                                                     .k6 = 1.1,
                                                     .p1 = 6e-4,
                                                     .p2 = -4e-4});
        case CameraLens::kFisheye:
            return camera::Lens(camera::FisheyeLens{.f_px = 790.0,
                                                    .cx_px = 636.8,
                                                    .cy_px = 362.4,
                                                    .k1 = -0.021,
                                                    .k2 = 0.006,
                                                    .k3 = -0.002,
                                                    .k4 = 2e-4});
        case CameraLens::kThesis:
            return thesisLens();
    }
    return webcam;
}

void knock(camera::Mount& mount, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> moved_m(-0.008, 0.008), turned_gon(-0.8, 0.8);
    for (double& offset_m : mount.offset_m) {
        offset_m += moved_m(engine);
    }
    for (core::Angle* angle : {&mount.yaw, &mount.pitch, &mount.twist}) {
        *angle += core::Angle::fromGon(turned_gon(engine));
    }
}

}  // namespace

std::optional<CameraLens> cameraLensFromText(const QString& text) {
    constexpr std::pair<const char*, CameraLens> kNames[] = {{"brown", CameraLens::kBrown},
                                                             {"rational", CameraLens::kRational},
                                                             {"fisheye", CameraLens::kFisheye},
                                                             {"thesis", CameraLens::kThesis}};
    for (const auto& [name, lens] : kNames) {
        if (text == QLatin1String(name)) {
            return lens;
        }
    }
    return std::nullopt;
}

camera::Lens thesisLens() {
    camera::RadialTableLens table{.cx_px = 315, .cy_px = 240, .rows = {}};
    for (double radius_px = 0; radius_px <= 420; radius_px += 10) {
        table.rows.push_back({radius_px, core::Angle::fromGon(thesisAngle_gon(radius_px)).rad()});
    }
    return camera::Lens(std::move(table));
}

camera::Rig simulatedRig(const CameraChoice& choice) {
    camera::Rig rig = simulatedRig();
    rig.lens = lensOf(choice.lens, rig.lens);
    if (choice.lens == CameraLens::kThesis) {
        rig.width_px = 640;
        rig.height_px = 480;
    }
    rig.mount.kind = choice.mount;
    if (choice.rig_error != 0) {
        knock(rig.mount, choice.rig_error);
    }
    return rig;
}

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
