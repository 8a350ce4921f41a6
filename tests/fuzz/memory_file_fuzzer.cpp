#include "fuzz_input.hpp"

#include "pmts/protocol/label_backup.hpp"
#include "pmts/protocol/memory_file.hpp"
#include "pmts/protocol/memory_records.hpp"

#include <algorithm>

using namespace pmts::protocol;
using pmts::fuzz::demand;

namespace {

bool isSameContent(const MemoryLine& a, const MemoryLine& b) { return a.label == b.label && a.data == b.data; }

void checkFile(std::string_view bytes) {
    const MemoryFile file = parseMemoryFile(bytes);
    const MemoryFile again = parseMemoryFile(memoryFileText(file.lines));
    demand(again.bad.empty(), "what was read is written without bad lines");
    demand(std::ranges::equal(file.lines, again.lines, isSameContent), "what was read is written the same");
    for (const BadLine& bad : file.bad) {
        demand(bad.number > 0, "a bad line has a number");
    }
    const MemoryRecords records = recordsOf(file, unitsIn(file).value_or(WireUnits{}));
    for (const PointCheck& check : checkPoints(records)) {
        demand(check.point < records.points.size(), "a check is of a point of the file");
    }
}

void checkBackup(std::string_view bytes) {
    if (const auto backup = parseBackup(bytes)) {
        const auto again = parseBackup(backupText(*backup));
        demand(again.has_value() && again->readings.size() == backup->readings.size(), "a backup that was read is written whole");
        demand(changesBetween(*backup, *backup).empty(), "nothing changes between a backup and itself");
    }
}

}  // namespace

/// Job and area files with their variants, and the label backups that are compared.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = pmts::fuzz::textOf(data, size);
    checkFile(bytes);
    checkBackup(bytes);
    return 0;
}
