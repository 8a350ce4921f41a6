#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pmts::protocol {

/// One `label=data` line of a job or area file and where it stood, counted from 1. In a Geodat 124 dump several
/// items share a line.
struct MemoryLine {
    int number = 0;
    int label = 0;
    std::string data;  ///< bytes as they are: the national 7-bit sets are not UTF-8

    [[nodiscard]] bool operator==(const MemoryLine&) const = default;
};

/// What the instrument would refuse with 34 (no `=`) or 35 (no label, no value).
enum class BadLineKind { kNoEquals, kNoLabel, kNoData };

struct BadLine {
    int number = 0;
    BadLineKind kind = BadLineKind::kNoEquals;
    std::string text;

    [[nodiscard]] bool operator==(const BadLine&) const = default;
};

/// A JOB or ARE file (protocol page 6) as lines; what is no line is kept beside them with its number.
struct MemoryFile {
    std::vector<MemoryLine> lines;
    std::vector<BadLine> bad;
    bool is_geodat_dump = false;

    [[nodiscard]] bool operator==(const MemoryFile&) const = default;
};

/// CR LF, LF or CR; the first `=` parts label and data; labels nobody knows are kept. A line in quotes is one of a
/// Geodat 124 dump: `"12,4=WALL 5=101 7=89.4216 "`, where dashes for data mean that there is none.
[[nodiscard]] MemoryFile parseMemoryFile(std::string_view bytes);

/// As the instrument writes it: `label=data` CR LF.
[[nodiscard]] std::string memoryFileText(const std::vector<MemoryLine>& lines);

}  // namespace pmts::protocol
