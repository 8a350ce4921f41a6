#pragma once

#include "exchange.hpp"

namespace pmts::instrument {

/// What a label holds, from one undamaged answer. Numeric labels must have their usual count of decimals.
[[nodiscard]] core::Task<core::Result<std::string>> readText(StatePtr state, int label, std::stop_token stop);

/// The same, when it leads over other readings as far as the line's quality demands. `already`: an earlier
/// reading that counts.
[[nodiscard]] core::Task<core::Result<std::string>> readAgreedText(StatePtr state, int label,
                                                                   std::string already, std::stop_token stop);

/// A circle reading. Within `within` of the expected value one reading is enough (a lost digit never lands
/// there); otherwise several must agree within the reading noise.
[[nodiscard]] core::Task<core::Result<core::Angle>> readAngle(StatePtr state, int label,
                                                              std::optional<core::Angle> expected,
                                                              core::Angle within, std::stop_token stop);

/// Both circles, verified; kept as the latest pointing and reported.
[[nodiscard]] core::Task<core::Result<geometry::Pointing>> readVerifiedPointing(StatePtr state,
                                                                                std::stop_token stop);

/// Both circles at poll priority, one question each. A value that fits no motion since the last one waits for
/// the next poll to confirm it; then the earlier pointing is returned.
[[nodiscard]] core::Task<core::Result<geometry::Pointing>> pollCircles(StatePtr state, std::stop_token stop);

/// A number as it stands in a block, when its shape is believable for the label.
[[nodiscard]] bool isBelievableNumber(GeodimeterState& state, int decimals_key, std::string_view text);
[[nodiscard]] core::Result<core::Angle> circleAngle(const GeodimeterState& state, std::string_view text);
/// HA differences go the short way round; VA has no way round.
[[nodiscard]] core::Angle circleDifference(core::Angle a, core::Angle b);

void keepPointing(GeodimeterState& state, const geometry::Pointing& pointing);
/// A pointing seen in passing (a measuring poll): kept and reported when it fits the motion since the last.
void notePointing(GeodimeterState& state, std::optional<core::Angle> ha, std::optional<core::Angle> va);

}  // namespace pmts::instrument
