#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pmts::simulator {

/// A command as the station reads it: verb, unit and letters, then `,number`, then `=data` (protocol
/// page 1.2).
struct CommandLine {
    char verb = 0;                    ///< R W P T O L K M
    char unit = 0;                    ///< G R S V M I U D *; 0 for the bare M
    std::string arguments;            ///< letters after the unit: `N`, `<`, `C`, a protocol number
    std::optional<int> number;        ///< after the comma
    std::optional<std::string> data;  ///< after the first `=`, as sent
};

/// nullopt: status 30, syntax error; lower case letters are one. `line` without its CR.
[[nodiscard]] std::optional<CommandLine> parseCommandLine(std::string_view line);

}  // namespace pmts::simulator
