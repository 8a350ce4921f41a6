#pragma once

#include "pmts/protocol/instruction_table.hpp"
#include "pmts/protocol/line_decoding.hpp"

#include <QStringList>

#include <span>

namespace pmts::protocol {

/// Whether a line could be a command: verb, unit letter, letters, `,number`, `=data` (protocol page 1.2), 80 characters at most.
[[nodiscard]] bool isSeenCommand(std::string_view line);

/// A dialogue as a routine: commands in their order, with every reply that was seen to each.
struct SeenRoutine {
    TableRoutine routine;
    QStringList left_out;  ///< one sentence for each command that is not in it: doubtful, forbidden, not understood
};

/// Commands and replies of a capture. The same command several times in a row is one step with all its replies; a value
/// that changes is expected as `7=*`; the running stream (`A,166=…`) is no reply; a command without a reply becomes optional.
/// Where the side is not known, what looks like a command is one.
[[nodiscard]] SeenRoutine seenRoutine(std::span<const DecodedCharacter> characters, const std::string& name,
                                      const std::string& note);

/// The text that readInstructionTable() reads. Remarks become comments at its head.
[[nodiscard]] std::string instructionTableText(std::span<const TableRoutine> routines, const std::vector<std::string>& remarks);

}  // namespace pmts::protocol
