#pragma once

#include "pmts/protocol/line_decoding.hpp"

#include <QString>

namespace pmts::protocol {

/// A variable as the running stream of dialect B tells it (`A,166=96.16838`), or a label as a station answers (`7=10.2345`).
struct StreamValue {
    char unit = 'A';  ///< letter of the unit that sent it; G, the station, where none is said
    int variable = 0;
    double value = 0.0;
    std::uint64_t sample = 0;  ///< of its first character
};

/// Every complete value whose characters are sure, in order.
[[nodiscard]] std::vector<StreamValue> streamValues(std::span<const DecodedCharacter> characters);

/// A variable of the stream that may be what the panel shows.
struct PanelMatch {
    StreamValue stream;     ///< the value that fits best
    QString units;          ///< `gon, shown as degrees.minutes.seconds`
    QString shown;          ///< the stream's value as the panel would show it
    double off = 0.0;       ///< from the panel's number, in its last place
    double score = 0.0;     ///< 0 to 1; 1 within half of the last place
};

/// What the panel showed, as it was typed (`86.33.06`, `96.1684`), compared with every variable in every unit the
/// instruments know: gon, degrees, degrees.minutes.seconds, mil, m, ft. Best first, at most ten; kBadInput for a text
/// that is no number.
[[nodiscard]] core::Result<std::vector<PanelMatch>> correlated(const QString& panel_text,
                                                               const std::vector<StreamValue>& values);

}  // namespace pmts::protocol
