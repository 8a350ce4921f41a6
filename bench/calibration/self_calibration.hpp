#pragma once

namespace pmts::bench {

/// Figures 1 to 4 of the laboratory: self-calibration over the simulator's truth, with angle noise and either
/// the matcher's noise level (many seeds) or drawn frames and the real matcher (few).
void selfCalibration();

/// The thesis's own photo: eight parameters, level pitch, handle.
void thesisPhoto();

}  // namespace pmts::bench
