#pragma once

namespace pmts::bench {

/// Time and memory of the simulated camera over the built-in scene.
#if PMTS_BENCH_SCENE
void sceneDraw();
#else
inline void sceneDraw() {}
#endif

}  // namespace pmts::bench
