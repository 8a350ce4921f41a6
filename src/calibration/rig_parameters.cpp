#include "rig_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pmts::calibration {
namespace {

using camera::BrownLens;
using core::Angle;

/// Calls `use` with the raw number the parameter stands for; angles pass through radians.
template <class Use>
void visitParameter(BrownLens& lens, camera::Mount& mount, RigParameter parameter, Use use) {
    const auto useAngle = [&use](Angle& angle) {
        double rad = angle.rad();
        if (use(rad)) {
            angle = Angle::fromRad(rad);
        }
    };
    switch (parameter) {
        case RigParameter::kFocalLength:
            use(lens.f_px);
            return;
        case RigParameter::kCentreX:
            use(lens.cx_px);
            return;
        case RigParameter::kCentreY:
            use(lens.cy_px);
            return;
        case RigParameter::kK1:
            use(lens.k1);
            return;
        case RigParameter::kK2:
            use(lens.k2);
            return;
        case RigParameter::kK3:
            use(lens.k3);
            return;
        case RigParameter::kP1:
            use(lens.p1);
            return;
        case RigParameter::kP2:
            use(lens.p2);
            return;
        case RigParameter::kYaw:
            useAngle(mount.yaw);
            return;
        case RigParameter::kPitch:
            useAngle(mount.pitch);
            return;
        case RigParameter::kTwist:
            useAngle(mount.twist);
            return;
        case RigParameter::kOffsetX:
            use(mount.offset_m.x());
            return;
        case RigParameter::kOffsetY:
            use(mount.offset_m.y());
            return;
        case RigParameter::kOffsetZ:
            use(mount.offset_m.z());
            return;
    }
    throw std::logic_error("no such rig parameter");
}

}  // namespace

double parameterOf(const camera::Rig& rig, RigParameter parameter) {
    BrownLens lens = std::get<BrownLens>(rig.lens.model());
    camera::Mount mount = rig.mount;
    double value = 0.0;
    visitParameter(lens, mount, parameter, [&value](const double& stored) {
        value = stored;
        return false;
    });
    return value;
}

std::optional<camera::Rig> rigWith(const camera::Rig& initial, const std::vector<RigParameter>& parameters,
                                   const double* values) {
    BrownLens lens = std::get<BrownLens>(initial.lens.model());
    camera::Rig rig = initial;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        visitParameter(lens, rig.mount, parameters[i], [&](double& stored) {
            stored = values[i];
            return true;
        });
    }
    const bool finite =
        std::all_of(values, values + parameters.size(), [](double value) { return std::isfinite(value); });
    if (!finite || !(lens.f_px > 0)) {
        return std::nullopt;
    }
    rig.lens = camera::Lens(lens);
    return rig;
}

std::vector<RigParameter> thesisParameters() {
    using enum RigParameter;
    return {kFocalLength, kCentreX, kCentreY, kTwist, kOffsetY, kOffsetZ, kPitch, kK1};
}

QString parameterName(RigParameter parameter) {
    constexpr const char* kNames[] = {"f [px]",      "cx [px]", "cy [px]", "k1",        "k2",
                                      "k3",          "p1",      "p2",      "yaw [rad]", "pitch [rad]",
                                      "twist [rad]", "Xo [m]",  "Yo [m]",  "Zo [m]"};
    return QString::fromLatin1(kNames[static_cast<int>(parameter)]);
}

}  // namespace pmts::calibration
