#pragma once

#include "pmts/protocol/line_decoding.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pmts::protocol {

/// A character in words: itself, `<CR>`, `<EOT>`, `<hh>`; one that is not sure stands in `[?..]`.
[[nodiscard]] std::string shownCharacter(const DecodedCharacter& character);
/// Bytes in words, as shownCharacter() has them.
[[nodiscard]] std::string shownBytes(std::string_view bytes);
/// `41 2C? 31`: two hexadecimal digits each, a question mark behind one that is not sure.
[[nodiscard]] std::string hexOf(std::span<const DecodedCharacter> characters);

/// Bytes without a line behind them, such as a terminal program stores: character i at sample i.
[[nodiscard]] std::vector<DecodedCharacter> charactersOf(std::string_view bytes, TalkSide side = TalkSide::kUnknown,
                                                         std::uint64_t first_sample = 0);
/// Two lines of one capture in the order of time.
[[nodiscard]] std::vector<DecodedCharacter> mergedTalk(const std::vector<DecodedCharacter>& a,
                                                       const std::vector<DecodedCharacter>& b);

/// Neighbouring characters that were said in one breath.
struct TalkLine {
    std::size_t first = 0;  ///< of its characters
    std::uint32_t count = 0;
    std::uint32_t unsure = 0;  ///< of them
};

/// A line ends behind its end marks (CR, LF, EOT, `>`, as many as follow one another), where the side changes, before a
/// pause of more than `pause_samples`, and after 32 characters.
[[nodiscard]] std::vector<TalkLine> talkLines(std::span<const DecodedCharacter> characters, double pause_samples);

/// Whether most complete lines are commands of the protocol (`WV,102=0`): then they went to the instrument. kUnknown
/// when there are no complete lines.
[[nodiscard]] TalkSide likelySide(std::span<const DecodedCharacter> characters);

/// What to look for, as it was typed: text, `<CR>` and its kin, or bytes as hexadecimal numbers (`0D 41`). kBadInput for
/// an empty one.
[[nodiscard]] core::Result<std::string> searchedBytes(std::string_view typed);

}  // namespace pmts::protocol
