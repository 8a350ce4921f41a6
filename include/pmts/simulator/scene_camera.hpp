#pragma once

#include "pmts/camera/frame.hpp"
#include "pmts/camera/rig.hpp"
#include "pmts/simulator/scene.hpp"
#include "pmts/simulator/world.hpp"

#include <memory>

namespace pmts::simulator {

struct CameraFaults {
    double noise_sigma = 2.0;  ///< grey values
    double blur_px = 0.0;
    double exposure_gain = 1.0;
    unsigned seed = 1;
};

/// Draws the frames of a camera mounted on the simulated instrument, from its true pointing. One thread, the camera's.
/// 1280x720 in <= 20 ms on one core: each panel by a homography, then one lens remap.
class SceneCamera {
public:
    SceneCamera(std::shared_ptr<const Scene> scene, std::shared_ptr<const TruePointing> pointing, camera::Rig true_rig, CameraFaults faults);
    ~SceneCamera();

    /// The frame of this moment; `pointing` stays empty: a camera knows no circles.
    [[nodiscard]] camera::Frame draw(core::Duration captured_at);
    /// Exposure, focus and noise of the frames from now on.
    void setFaults(const CameraFaults& faults);

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace pmts::simulator
