#pragma once

namespace pmts::bench {

/// Twist from the plumb line, offsets from the boards and the distortion table, all in the laboratory scene.
/// False when something could not be measured at all.
bool mountingFigures();

}  // namespace pmts::bench
