#pragma once

#include "pmts/protocol/reply.hpp"
#include "pmts/protocol/units.hpp"

#include <QString>

#include <functional>
#include <optional>
#include <string_view>

namespace pmts::protocol {

/// What people call a label of a unit (G station, R control unit, S servo, V main board, A angle unit); empty: nothing.
using NameOf = std::function<QString(char unit, int number)>;

/// A command in plain language, with the names of the labels: `RG,7` is `read HA`, `PV,8=9` `run process 8 of the main board
/// with 9`. Absent: no command of either dialect. `units`: label 23, when known; then numbers carry their unit. A name of
/// `name_of` goes before the maker's.
[[nodiscard]] std::optional<QString> commandInWords(std::string_view command,
                                                    const std::optional<WireUnits>& units = std::nullopt,
                                                    const NameOf& name_of = nullptr);

/// How the answer to a command's text is read; the standard form where the text is no reading command.
[[nodiscard]] ReplyShape shapeOfAnswerTo(std::string_view command);

/// The answer to a command: `HA 10.2345 gon, VA 96.1684 gon`, `done`, `info 156: …`. Empty for an empty block without
/// meaning.
[[nodiscard]] QString replyInWords(std::string_view command, const Reply& reply,
                                   const std::optional<WireUnits>& units = std::nullopt, const NameOf& name_of = nullptr);

}  // namespace pmts::protocol
