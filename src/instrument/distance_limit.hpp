#pragma once

#include "geodimeter_state.hpp"

#include <optional>
#include <string>

namespace pmts::instrument {

// How long a distance may take: TT is learned by mode and range class, L follows (thesis 8.4.2).

/// D-bar: repeats and averages until it is ended.
[[nodiscard]] bool averages(EdmMode mode);
[[nodiscard]] const EdmTiming& timingOf(const GeodimeterState& state);
/// The usual time, for the progress and for where polling must be dense. `q`: its quantile.
[[nodiscard]] std::optional<core::Duration> usualTime(const GeodimeterState& state, double q);
/// `STD 50-200 m`: what TT is learned by.
[[nodiscard]] std::string timingKey(EdmMode mode, double slope_distance_m);
/// L for the next distance: of the expected range class, else the longest of the mode's classes.
[[nodiscard]] core::Duration learnedLimit(const GeodimeterState& state);

}  // namespace pmts::instrument
