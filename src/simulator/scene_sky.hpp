#pragma once

#include "pmts/simulator/scene.hpp"

#include <vector>

namespace pmts::simulator {

/// Six faces of a cube with a half side of 1 m around the camera: clouds above, hills along the horizon.
[[nodiscard]] std::vector<Panel> cloudySky(unsigned seed);

}  // namespace pmts::simulator
