#include "fuzz_input.hpp"

#include "pmts/protocol/command.hpp"
#include "pmts/protocol/instruction_table.hpp"

#include <algorithm>
#include <cmath>

using namespace pmts::protocol;
using pmts::fuzz::demand;

namespace {

/// What is sent with each placeholder at `share` of its range.
void checkBytes(const TableStep& step, double share) {
    std::map<std::string, double> numbers;
    TableRoutine alone;
    alone.steps = {step};
    for (const TableParameter& parameter : alone.parameters()) {
        const double least = parameter.least.value_or(0.0);
        numbers[parameter.name] = std::round(least + share * (parameter.most.value_or(least + 200.0) - least));
    }
    if (const auto bytes = bytesOf(step, numbers)) {
        demand(bytes->ends_with('\r') && std::ranges::count(*bytes, '\r') == 1, "one command to a step");
        demand(checkDenyList(*bytes).has_value(), "a table without problems sends nothing that is denied");
    }
}

void checkStep(const TableStep& step) {
    demand(step.line > 0, "a step knows its line");
    for (const double share : {0.0, 0.5, 0.635, 1.0}) {  // 0.635 of 200 is label 127
        checkBytes(step, share);
    }
    for (const std::string_view reply : {"0.8", "240.8", "35", "", "nonsense"}) {
        (void)judge(step, reply);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = pmts::fuzz::textOf(data, size);
    const InstructionTable table = readInstructionTable(text);
    const auto lines = 1 + std::ranges::count(text, '\n');
    for (const TableProblem& problem : table.problems) {
        demand(problem.line >= 1 && problem.line <= lines, "a problem names a line of the file");
        demand(!problem.sentence.isEmpty(), "a problem has a sentence");
    }
    if (table.problems.empty()) {
        for (const TableRoutine& routine : table.routines) {
            demand(table.find(routine.name) != nullptr, "a routine is found by its name");
            std::ranges::for_each(routine.steps, checkStep);
        }
    }
    return 0;
}
