#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/result.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmts::protocol {

// Routines of the bus dialect are data (protocol page 5.4): the codes of most are not published, a lab user adds what is
// found out. The format is explained at the head of resources/instructions/geodimeter-bus.txt.

/// A number that the caller gives: `{mode 0..4}` in the text of a command.
struct TableParameter {
    std::string name;
    std::optional<double> least, most;

    [[nodiscard]] bool operator==(const TableParameter&) const = default;
};

/// One micro-instruction.
struct TableStep {
    int line = 0;                     ///< of the file, from 1
    std::string text;                 ///< with its placeholders, without CR
    std::vector<std::string> expect;  ///< `240.8`, or `24*` for whatever begins so
    std::vector<std::string> fail;
    core::Duration within = std::chrono::seconds(5);
    bool optional = false;  ///< the reply may be missing
    bool time_critical = false;
    bool always = false;      ///< also after a step that went wrong or a cancel: gives back what was taken
    core::Duration pause{0};  ///< after the reply, before the next step
};

struct TableRoutine {
    int line = 0;
    std::string name;
    std::string note;
    std::vector<TableStep> steps;

    [[nodiscard]] std::vector<TableParameter> parameters() const;  ///< each once, in their order
};

struct TableProblem {
    int line = 0;
    QString sentence;
};

struct InstructionTable {
    std::vector<TableRoutine> routines;
    std::vector<TableProblem> problems;  ///< of the whole file, by line; a table with any must not be run

    [[nodiscard]] const TableRoutine* find(std::string_view name) const;  ///< null: there is none
};

/// Reads and checks: grammar of the commands, deny list, placeholders, replies that contradict one another.
[[nodiscard]] InstructionTable readInstructionTable(std::string_view text);

/// The bytes of a step, CR included. Fails with kBadInput where a number is missing, out of its range or makes no command,
/// with kRefused where it makes one of the deny list.
[[nodiscard]] core::Result<std::string> bytesOf(const TableStep& step, const std::map<std::string, double>& numbers);

enum class TableVerdict {
    kExpected,
    kFailed,   ///< listed as a failure
    kUnknown,  ///< neither: ends the routine as a failure does
};
/// `block`: a reply without its block end; CR and LF at its ends do not count.
[[nodiscard]] TableVerdict judge(const TableStep& step, std::string_view block);

}  // namespace pmts::protocol
