#pragma once

namespace pmts::bench {

/// The time-critical start-up on the bus beside live 1080p video: with the video gate, and without it.
void startUpFigures();

}  // namespace pmts::bench
