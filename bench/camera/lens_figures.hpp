#pragma once

namespace pmts::bench {

/// Each lens model against OpenCV's of the same name: farthest pixel apart, and the time of the way back to the ray.
void lensFigures();

}  // namespace pmts::bench
