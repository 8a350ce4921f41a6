#pragma once

#include "pmts/camera/rig.hpp"
#include "pmts/simulator/scene.hpp"
#include "pmts/simulator/scene_camera.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace pmts::bench {

/// One series of clicks, each followed by a re-centring over the simulated instrument and camera.
struct ClickSeries {
    std::shared_ptr<const simulator::Scene> scene;
    camera::Rig true_rig;
    camera::Rig believed_rig;
    int clicks = 100;
    unsigned seed = 1;
    double exposure_drift = 0.3;  ///< the frames after the click are up to this much brighter or darker
    double most_tilt_gon = 15.0;
    double most_ha_gon = 200.0;  ///< either side of north
    bool count_refused = false;  ///< `clicks` counts those refused at the click too
};

/// What became of it. "Truth" is the clicked 3D point seen through the true rig at the true pointing.
struct ClickOutcome {
    int clicks = 0;   ///< with enough detail to be accepted
    int refused = 0;  ///< sky, plain wall, look-alikes: said at the click, nothing turned
    int settled = 0, settled_in_two = 0, settled_in_three = 0;
    std::map<std::string, int> failures;  ///< by the first word of Error::detail
    int wrong = 0;                        ///< reported as settled more than 1 px from the clicked spot
    double open_loop_rms_px = 0;          ///< after the first move, truth against the true reticle
    double rms_px = 0, rms_arcsec = 0;    ///< of the settled, truth against the reticle
    double largest_px = 0;
    std::vector<double> step_ms;  ///< one find step each
};

[[nodiscard]] ClickOutcome runClicks(const ClickSeries& series);

}  // namespace pmts::bench
