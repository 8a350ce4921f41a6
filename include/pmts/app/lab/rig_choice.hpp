#pragma once

#include "pmts/app/lab/rig_profile.hpp"

#include <vector>

namespace pmts::app {

/// How well a profile suits the camera as it stands, best first.
enum class RigFitness {
    kFits,        ///< made with this camera in this mode
    kNominal,     ///< the simulated camera's own numbers
    kUnassigned,  ///< belongs to no camera; chosen by hand
    kOtherFocus,  ///< focus, zoom or pixel format were others
    kScaled,      ///< made at another size of the same shape, scaled
    kOtherShape,  ///< made at another size of another shape: scaled about the middle, a guess
    kOtherCamera,
};

/// The profile pictures are aimed with, and how far to trust it.
struct RigChoice {
    RigProfile profile;  ///< its rig is scaled to the picture where `fitness` says so
    RigFitness fitness = RigFitness::kNominal;
    QString sentence;    ///< `Webcam 1280x720 belongs to this camera and mode.`

    [[nodiscard]] bool deservesWarning() const { return fitness >= RigFitness::kOtherFocus; }
};

/// Picks among the profiles for a camera as it stands. `automatic`: the one that fits best, the chosen one first among
/// equals; else the chosen one, if there is one. What nothing fits gets the chosen one, or the simulated camera's own.
[[nodiscard]] RigChoice pickRig(const std::vector<RigProfile>& profiles, const QString& chosen, bool automatic,
                                const CameraUse& now);

/// How well this profile suits, whatever the others are.
[[nodiscard]] RigFitness fitnessOf(const RigProfile& profile, const CameraUse& now);

/// `Webcam 1280x720`, with a number behind it when that name is taken.
[[nodiscard]] QString freeProfileName(const std::vector<RigProfile>& profiles, const CameraUse& use);
[[nodiscard]] QString freeProfileName(const std::vector<RigProfile>& profiles, const QString& wanted);

}  // namespace pmts::app
