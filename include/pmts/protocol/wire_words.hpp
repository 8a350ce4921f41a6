#pragma once

#include "pmts/protocol/reply.hpp"
#include "pmts/protocol/units.hpp"

#include <QString>

#include <optional>
#include <string_view>

namespace pmts::protocol {

/// A command in plain language, with the names of the labels: `RG,7` is `read HA`. Absent: no command of this dialect.
/// `units`: label 23, when known; then numbers carry their unit.
[[nodiscard]] std::optional<QString> commandInWords(std::string_view command,
                                                    const std::optional<WireUnits>& units = std::nullopt);

/// How the answer to a command's text is read; the standard form where the text is no reading command.
[[nodiscard]] ReplyShape shapeOfAnswerTo(std::string_view command);

/// The answer to a command: `HA 10.2345 gon, VA 96.1684 gon`, `done`, `info 156: …`. Empty for an empty block without
/// meaning.
[[nodiscard]] QString replyInWords(std::string_view command, const Reply& reply,
                                   const std::optional<WireUnits>& units = std::nullopt);

}  // namespace pmts::protocol
